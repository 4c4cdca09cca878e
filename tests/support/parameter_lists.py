"""Parameters in a controller file: python3 parameter_lists.py FORMAT FILE prints name and value (mm, deg or 1), one a line.

Each format is read as its own documentation describes it, with Python's standard library alone: nothing is shared with the exporter.
"""

import ast
import math
import re
import struct
import sys
import xml.etree.ElementTree as ElementTree
import zipfile

# mm, deg or 1 per unit
UNITS = {"mm": 1.0, "deg": 1.0, "1": 1.0}
# D-SI (SmartCom D2, table 1 to 3): units in the notation of siunitx
DSI = {r"\milli\metre": 1.0, r"\metre": 1e3, r"\degree": 1.0, r"\radian": math.degrees(1.0), r"\one": 1.0}
# a Galil program counts in these
GALIL = {"um": 1e-3, "1E-6 deg": 1e-6, "1E-6": 1e-6}


def npy(raw):
    """NumPy's format 1.0: magic, length of the header, header as a dictionary, data (numpy.lib.format)."""
    assert raw[:8] == b"\x93NUMPY\x01\x00"
    (length,) = struct.unpack_from("<H", raw, 8)
    header, data = ast.literal_eval(raw[10 : 10 + length].decode("latin1")), raw[10 + length :]
    assert (10 + length) % 64 == 0 and not header["fortran_order"]
    kind, (count, *_) = header["descr"], header["shape"]
    if kind.startswith("<U"):
        size = 4 * int(kind[2:])
        return [data[i * size : (i + 1) * size].decode("utf-32-le").rstrip("\0") for i in range(count)]
    return struct.unpack(f"<{count}{ {'<f8': 'd', '<u8': 'Q'}[kind] }", data[: 8 * count])


def numpy(file):
    with zipfile.ZipFile(file) as archive:
        columns = [npy(archive.read(f"{name}.npy")) for name in ("name", "unit", "value")]
    for name, unit, value in zip(*columns):
        yield name, value * UNITS[unit]


def elements(raw):
    """Data elements of a MAT-file of level 5: type, size, data up to a multiple of eight bytes; small ones are packed."""
    at = 0
    while at < len(raw):
        kind, size = struct.unpack_from("<II", raw, at)
        if kind >> 16:
            yield kind & 0xFFFF, raw[at + 4 : at + 4 + (kind >> 16)]
            at += 8
        else:
            yield kind, raw[at + 8 : at + 8 + size]
            at += 8 + (size + 7) // 8 * 8


def matrix(data):
    """Name and content of a miMATRIX: flags with the class in their first byte, dimensions, name, then the content."""
    (_, flags), (_, shape), (_, name), *rest = elements(data)
    if flags[0] == 1:  # mxCELL_CLASS
        content = [matrix(cell)[1] for _, cell in rest]
    elif flags[0] == 4:  # mxCHAR_CLASS, miUTF16
        content = rest[0][1].decode("utf-16-le")
    else:  # mxDOUBLE_CLASS, miDOUBLE
        assert flags[0] == 6 and rest[0][0] == 9
        content = struct.unpack(f"<{len(rest[0][1]) // 8}d", rest[0][1])
    return name.decode(), content


def mat(file):
    with open(file, "rb") as source:
        raw = source.read()
    assert raw[124:128] == b"\x00\x01IM"
    found = dict(matrix(data) for kind, data in elements(raw[128:]) if kind == 14)
    for name, unit, value in zip(found["name"], found["unit"], found["value"]):
        yield name, value * UNITS[unit]


def dcc(file):
    si = "{https://ptb.de/si}"
    for quantities in ElementTree.parse(file).getroot().iter(si + "realListXMLList"):
        columns = [quantities.find(f"{si}{of}XMLList").text.split() for of in ("label", "value", "unit")]
        assert len({len(column) for column in columns}) == 1
        for name, value, unit in zip(*columns):
            yield name, float(value) * DSI[unit]


def qif(file):
    q = "{http://qifstandards.org/xsd/qif3}"
    root = ElementTree.parse(file).getroot()
    by_id = {e.get("id"): e for e in root.iter() if e.get("id")}
    si = {of: float(root.find(f".//{q}PrimaryUnits/{q}{of}Unit/{q}UnitConversion/{q}Factor").text) for of in ("Linear", "Angular")}
    for measured in root.find(f".//{q}CharacteristicMeasurements"):
        item = by_id[measured.find(q + "CharacteristicItemId").text]
        nominal = by_id[item.find(q + "CharacteristicNominalId").text]
        kind, value = measured.tag.removeprefix(q), float(measured.find(q + "Value").text)
        if kind == "UserDefinedLinearCharacteristicMeasurement":
            value *= si["Linear"] * 1e3
        elif kind == "UserDefinedAngularCharacteristicMeasurement":
            value = math.degrees(value * si["Angular"])
        else:
            assert kind == "UserDefinedUnitCharacteristicMeasurement"
        yield nominal.find(q + "Name").text, value


def galil(file):
    with open(file) as source:
        text = source.read()
    body = text.split("\n#CALPAR\n")[1].split("\nEN\n")[0]
    for name, unit, value in re.findall(r"REM (\S+) in (.*), rounding .*\nKV\w{1,6}=(\S+)", body):
        yield name, float(value) * GALIL[unit]


def constants(text, real):
    for name, value, unit in re.findall(rf"c_(\w+) : {real} := ([^;]+); *// (\S+)", text):
        yield name, float(value) * UNITS[unit]


def twincat(file):
    yield from constants(ElementTree.parse(file).getroot().find("GVL/Declaration").text, "LREAL")


def plcopen(file):
    plc = "{http://www.plcopen.org/xml/tc6_0200}"
    for variable in ElementTree.parse(file).getroot().find(f".//{plc}globalVars"):
        assert variable.find(f"{plc}type/{plc}LREAL") is not None
        value = variable.find(f"{plc}initialValue/{plc}simpleValue").get("value")
        unit = variable.find(f"{plc}documentation")[0].text
        yield variable.get("name").removeprefix("c_"), float(value) * UNITS[unit]


def siemens_scl(file):
    with open(file) as source:
        text = source.read()
    yield from constants(text.split("DATA_BLOCK", 1)[1].split("END_DATA_BLOCK")[0], "LReal")


FORMATS = {"numpy": numpy, "mat": mat, "dcc": dcc, "qif": qif, "galil": galil, "twincat": twincat, "plcopen": plcopen, "siemens-scl": siemens_scl}
for name, value in FORMATS[sys.argv[1]](sys.argv[2]):
    print(name, repr(value), sep="\t")
