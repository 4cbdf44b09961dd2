"""Every function of the Modbus server, by pymodbus, on the port that is the argument. The program: output 01
follows input 01, which starts a TON of 70000 ms and counts C 01 up, to 5. Prints one line for each function, or ends with an error."""

import sys

from pymodbus import FramerType
from pymodbus.client import ModbusSerialClient
from pymodbus.pdu import ExceptionResponse

client = ModbusSerialClient(sys.argv[1], framer=FramerType.RTU, baudrate=115200, timeout=5, retries=0)
assert client.connect()


def sound(reply):
    assert not reply.isError(), reply
    return reply


def refused(reply, code):
    assert isinstance(reply, ExceptionResponse) and reply.exception_code == code, reply


assert sound(client.write_register(402, 1, device_id=1))  # input 01 is forced
assert sound(client.write_register(403, 1, device_id=1))
print("6: write a holding register")
assert sound(client.read_discrete_inputs(0, count=8, device_id=1)).bits == [True] + [False] * 7
print("2: read discrete inputs")
assert sound(client.read_coils(0, count=4, device_id=1)).bits[:4] == [True, False, False, False]
print("1: read coils")
sound(client.write_coil(1, True, device_id=1))
sound(client.write_coils(2, [True, True], device_id=1))
assert sound(client.read_coils(0, count=4, device_id=1)).bits[:4] == [True] * 4
sound(client.write_coil(16, True, device_id=1))  # M 01
sound(client.write_coils(78, [True, True], device_id=1))  # M 63, M 64
markers = sound(client.read_coils(16, count=64, device_id=1)).bits[:64]
assert [n + 1 for n, on in enumerate(markers) if on] == [1, 63, 64], markers
print("5, 15: write coils")
sound(client.write_registers(404, [0b0010, 0], device_id=1))
assert sound(client.read_holding_registers(402, count=4, device_id=1)).registers == [1, 1, 2, 0]
sound(client.write_registers(62, [0x1234, 0x5678], device_id=1))  # D 32
assert sound(client.read_holding_registers(60, count=4, device_id=1)).registers == [0, 0, 0x1234, 0x5678]
assert sound(client.read_holding_registers(128, count=4, device_id=1)).registers == [1, 4464, 0, 0]
sound(client.write_registers(128, [2, 0], device_id=1))  # the preset of T 01
assert sound(client.read_holding_registers(128, count=2, device_id=1)).registers == [2, 0]
print("3, 16: read and write holding registers")
registers = sound(client.read_input_registers(16, count=17, device_id=1)).registers
assert registers[0] == 1 and registers[1] == 0x100 | 0b100, registers
elapsed = sound(client.read_input_registers(128, count=2, device_id=1)).registers
assert 0 < elapsed[0] << 16 | elapsed[1], elapsed
assert sound(client.read_input_registers(320, count=4, device_id=1)).registers == [0, 1, 0, 0]
assert sound(client.read_input_registers(0, count=5, device_id=1)).registers == [0] * 5
print("4: read input registers")
texts = sound(client.read_device_information(read_code=1, device_id=1)).information
assert texts[0] == b"unoclp" and texts[1] == b"unoclp UNO", texts
print("43/14: identification")
refused(client.read_exception_status(device_id=1), 1)
refused(client.read_coils(0, count=5, device_id=1), 2)
refused(client.write_registers(130, [0, 1], device_id=1), 2)
refused(client.write_register(128, 0x8000, device_id=1), 3)
refused(client.write_register(402, 0x100, device_id=1), 3)
refused(client.write_register(410, 2, device_id=1), 4)
print("exceptions 1 to 4")
