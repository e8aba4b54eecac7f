# SPDX-License-Identifier: Apache-2.0
"""An importer of FMUs for co-simulation (FMI 2.0), just large enough for the tests: unpacks, reads the description, and
calls the library. `mistakes` holds the description against rules written from the text of the standard; it is not a schema
of the standard's authors. To check by that too, name its fmi2ModelDescription.xsd in IONSKIN_FMI2_SCHEMA."""

import ctypes
import os
import pathlib
import subprocess
import xml.etree.ElementTree
import zipfile

OK, WARNING, DISCARD, ERROR, FATAL, PENDING = range(6)
LAST_SUCCESSFUL_TIME, TERMINATED = 2, 3
CO_SIMULATION = 1
FUNCTIONS = {"fmi2" + name for name in (
    "GetTypesPlatform GetVersion SetDebugLogging Instantiate FreeInstance SetupExperiment EnterInitializationMode "
    "ExitInitializationMode Terminate Reset GetReal GetInteger GetBoolean GetString SetReal SetInteger SetBoolean "
    "SetString GetFMUstate SetFMUstate FreeFMUstate SerializedFMUstateSize SerializeFMUstate DeSerializeFMUstate "
    "GetDirectionalDerivative SetRealInputDerivatives GetRealOutputDerivatives DoStep CancelStep GetStatus "
    "GetRealStatus GetIntegerStatus GetBooleanStatus GetStringStatus").split()}
# Of variability: which causalities it may stand with (2.2.7, table of combinations), of the kinds that an FMU has here.
COMBINATIONS = {("input", "continuous"), ("input", "discrete"), ("output", "continuous"), ("output", "discrete"),
                ("output", "constant"), ("parameter", "fixed"), ("parameter", "tunable")}
CHILDREN = ["ModelExchange", "CoSimulation", "UnitDefinitions", "TypeDefinitions", "LogCategories", "DefaultExperiment",
            "VendorAnnotations", "ModelVariables", "ModelStructure"]

LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)
ALLOCATE = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t)
FREE = ctypes.CFUNCTYPE(None, ctypes.c_void_p)
FINISHED = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int)


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", LOGGER), ("allocate", ALLOCATE), ("free", FREE), ("finished", FINISHED),
                ("environment", ctypes.c_void_p)]


def mistakes(text):
    """Mistakes in a modelDescription.xml by the standard."""
    root = xml.etree.ElementTree.fromstring(text)
    found = []

    def require(holds, what):
        if not holds:
            found.append(what)

    require(root.tag == "fmiModelDescription", "root element")
    for name in ("fmiVersion", "modelName", "guid"):
        require(root.get(name), f"attribute {name}")
    require(root.get("fmiVersion") == "2.0", "version")
    order = [CHILDREN.index(child.tag) if child.tag in CHILDREN else -1 for child in root]
    require(order == sorted(set(order)) and -1 not in order, "order of the elements")
    simulation = root.find("CoSimulation")
    require(simulation is not None and simulation.get("modelIdentifier", "").isidentifier(), "modelIdentifier")
    units = [unit.get("name") for unit in root.iterfind("UnitDefinitions/Unit")]
    require(len(units) == len(set(units)), "units are unique")
    variables = root.findall("ModelVariables/ScalarVariable")
    names = [variable.get("name") for variable in variables]
    require(all(names) and len(names) == len(set(names)), "names are unique")
    require(all(variable.get("valueReference", "").isdigit() for variable in variables), "value references")
    for variable in variables:
        name, causality, initial = variable.get("name"), variable.get("causality"), variable.get("initial")
        require(len(variable) == 1 and variable[0].tag in ("Real", "Integer", "Boolean", "String"), f"{name}: type")
        kind = variable[0]
        variability = variable.get("variability", "continuous")
        require((causality, variability) in COMBINATIONS, f"{name}: {causality} and {variability}")
        require(kind.tag == "Real" or variability != "continuous", f"{name}: only reals are continuous")
        require("unit" not in kind.attrib or kind.get("unit") in units, f"{name}: unit")
        # An input has no initial and a start; what is calculated has no start; the exact has one.
        require((initial is None) == (causality == "input"), f"{name}: initial")
        require(("start" in kind.attrib) == (causality == "input" or initial == "exact"), f"{name}: start")
    outputs = [i for i, variable in enumerate(variables, 1) if variable.get("causality") == "output"]
    for part, expected in (("Outputs", outputs), ("InitialUnknowns", outputs)):
        listed = [int(unknown.get("index")) for unknown in root.iterfind(f"ModelStructure/{part}/Unknown")]
        require(listed == expected, f"ModelStructure/{part}")
    return found


def schema_mistakes(path):
    """Mistakes in a modelDescription.xml by the standard's own schema; None where no schema is named."""
    schema = os.environ.get("IONSKIN_FMI2_SCHEMA")
    if not schema:
        return None
    checked = subprocess.run(["xmllint", "--noout", "--schema", schema, path], capture_output=True, text=True, check=False)
    return "" if checked.returncode == 0 else checked.stderr


class Fmu:
    """An unpacked FMU."""

    def __init__(self, path, folder):
        self.folder = pathlib.Path(folder)
        with zipfile.ZipFile(path) as archive:
            assert archive.testzip() is None
            archive.extractall(self.folder)
        self.description_file = self.folder / "modelDescription.xml"
        self.description = self.description_file.read_text(encoding="utf-8")
        root = xml.etree.ElementTree.fromstring(self.description)
        self.guid = root.get("guid")
        self.capabilities = root.find("CoSimulation").attrib
        self.binary = self.folder / "binaries" / "linux64" / (self.capabilities["modelIdentifier"] + ".so")
        self.variables = {variable.get("name"): variable for variable in root.iterfind("ModelVariables/ScalarVariable")}
        self.references = {name: int(variable.get("valueReference")) for name, variable in self.variables.items()}
        self.library = ctypes.CDLL(str(self.binary))
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        self.library.fmi2GetVersion.restype = self.library.fmi2GetTypesPlatform.restype = ctypes.c_char_p


class Instance:
    """One simulation. Every call returns its status; `logged` holds what was logged."""

    def __init__(self, fmu, guid=None, resources=None, kind=CO_SIMULATION):
        self.fmu, self.library, self.logged = fmu, fmu.library, []
        self._callbacks = Callbacks(LOGGER(self._log), ALLOCATE(), FREE(), FINISHED(), None)
        self.handle = self.library.fmi2Instantiate(
            b"skin", kind, (guid or fmu.guid).encode(),
            (resources or (fmu.folder / "resources").as_uri()).encode(), ctypes.byref(self._callbacks), 0, 0)

    def _log(self, _environment, _name, status, category, message):
        self.logged.append((status, category.decode(), message.decode()))

    def call(self, name, *arguments):
        return getattr(self.library, "fmi2" + name)(ctypes.c_void_p(self.handle), *arguments)

    def begin(self, start=0.0, **inputs):
        """Takes the unit through the initialization mode."""
        return (self.call("SetupExperiment", 0, ctypes.c_double(0), ctypes.c_double(start), 0, ctypes.c_double(0)),
                self.call("EnterInitializationMode"), *self.set(**inputs), self.call("ExitInitializationMode"))

    def set(self, **values):
        """Reals, and force_control, by name."""
        statuses = []
        for name, value in values.items():
            reference = (ctypes.c_uint * 1)(self.fmu.references[name])
            if isinstance(value, bool):
                statuses.append(self.call("SetBoolean", reference, ctypes.c_size_t(1), (ctypes.c_int * 1)(value)))
            else:
                statuses.append(self.call("SetReal", reference, ctypes.c_size_t(1), (ctypes.c_double * 1)(value)))
        return statuses

    def get(self, names):
        """Values of reals."""
        references = (ctypes.c_uint * len(names))(*(self.fmu.references[name] for name in names))
        values = (ctypes.c_double * len(names))()
        status = self.call("GetReal", references, ctypes.c_size_t(len(names)), values)
        assert status == OK, self.logged
        return list(values)

    def flags(self):
        value = (ctypes.c_int * 1)()
        status = self.call("GetInteger", (ctypes.c_uint * 1)(self.fmu.references["flags"]), ctypes.c_size_t(1), value)
        assert status == OK, self.logged
        return value[0]

    def step(self, point, size):
        return self.call("DoStep", ctypes.c_double(point), ctypes.c_double(size), 0)

    def state(self, into=None):
        """A new state, or the given one anew."""
        state = into or ctypes.c_void_p()
        assert self.call("GetFMUstate", ctypes.byref(state)) == OK, self.logged
        return state

    def serialized(self, state):
        size = ctypes.c_size_t()
        assert self.call("SerializedFMUstateSize", state, ctypes.byref(size)) == OK
        content = ctypes.create_string_buffer(size.value)
        assert self.call("SerializeFMUstate", state, content, size) == OK
        return content.raw
