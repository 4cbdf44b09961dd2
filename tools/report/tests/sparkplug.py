"""Reads messages of Sparkplug B by pysparkplug: verb, device and hexadecimal digits a line, JSON a line.

With a name, a type and a value: prints a command for that metric in hexadecimal digits.
"""

import json
import sys

import pysparkplug

KINDS = {
    "NBIRTH": pysparkplug.NBirth,
    "NDATA": pysparkplug.NData,
    "DBIRTH": pysparkplug.DBirth,
    "DDATA": pysparkplug.DData,
    "DDEATH": pysparkplug.DDeath,
    "NDEATH": pysparkplug.NDeath,
}

if len(sys.argv) == 4:
    name, kind, value = sys.argv[1:]
    kind = pysparkplug.DataType[kind]
    metric = pysparkplug.Metric(timestamp=1, name=name, datatype=kind, value=json.loads(value))
    command = pysparkplug.DCmd(timestamp=1, metrics=(metric,))
    print(command.encode(include_dtypes=True).hex())
    sys.exit()

births = {}
for line in sys.stdin:
    verb, device, digits = (line.rstrip("\n").split(" ") + ["", ""])[:3]
    kind = KINDS[verb]
    message = kind.decode(bytes.fromhex(digits), birth=births.get(device))
    if verb in ("NBIRTH", "DBIRTH"):
        births[device] = message
    told = {"verb": verb, "device": device, "seq": getattr(message, "seq", None)}
    if verb == "NDEATH":
        told["bd_seq"] = message.bd_seq_metric.value
    for metric in getattr(message, "metrics", ()):
        told.setdefault("metrics", {})[metric.name] = [
            metric.datatype.name,
            metric.value,
            metric.is_historical,
            metric.is_null,
        ]
    print(json.dumps(told))
