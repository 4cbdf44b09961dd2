"""Every function of Modbus TCP, by pymodbus, at the port that is the argument. Unit 1 lets write D 01 and M 01. Prints one
line for each function, or ends with an error."""

import sys

from pymodbus.client import ModbusTcpClient
from pymodbus.pdu import ExceptionResponse

client = ModbusTcpClient("127.0.0.1", port=int(sys.argv[1]), timeout=5, retries=0)
assert client.connect()


def sound(reply):
    assert not reply.isError(), reply
    return reply


def refused(reply, code):
    assert isinstance(reply, ExceptionResponse) and reply.exception_code == code, reply


sound(client.write_registers(0, [0x1234, 0x5678], device_id=1))  # D 01
sound(client.write_register(1, 0x5679, device_id=1))
assert sound(client.read_holding_registers(0, count=4, device_id=1)).registers == [0x1234, 0x5679, 0, 0]
print("3, 6, 16: read and write holding registers")
sound(client.write_coil(16, True, device_id=1))  # M 01
sound(client.write_coils(16, [True], device_id=1))
assert sound(client.read_coils(16, count=8, device_id=1)).bits == [True] + [False] * 7
print("1, 5, 15: read and write coils")
assert sound(client.read_discrete_inputs(0, count=8, device_id=2)).bits == [False] * 8
print("2: read discrete inputs")
assert sound(client.read_input_registers(16, count=17, device_id=2)).registers[0] == 1
print("4: read input registers")
texts = sound(client.read_device_information(read_code=1, device_id=1)).information
assert texts[0] == b"unoclp", texts
print("43/14: identification")
refused(client.write_register(400, 2, device_id=1), 1)
refused(client.write_coil(0, True, device_id=1), 1)
refused(client.write_coil(16, True, device_id=2), 1)
refused(client.read_coils(0, count=1, device_id=9), 10)
refused(client.read_coils(0, count=5, device_id=1), 2)
print("refused: what is not named")
