# SPDX-License-Identifier: Apache-2.0
"""Distributions of keys, read from texts such as "contact.friction=uniform(0.1, 0.4)"."""

import math
import re
from typing import Any, NamedTuple

import numpy

from .. import solver
from ..case import Case
from ..errors import CaseError
from ..evaluation.libraries import need

CALL = re.compile(r"\s*([A-Za-z_]+)\s*\((.*)\)\s*")
NUMBER = re.compile(r"\s*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)\s*(.*?)\s*")
FORMS = {
    "uniform": "uniform(lowest, highest)",
    "loguniform": "loguniform(lowest, highest)",
    "triangular": "triangular(lowest, mode, highest)",
    "normal": "normal(mean, deviation) or normal(mean, deviation, lowest, highest), which is truncated",
    "lognormal": "lognormal(mean, deviation)",
}
KNOWN = "known: " + "; ".join(FORMS.values()) + ". A deviation may be relative: 20 %"
TAIL = 1e-6  # beyond these quantiles nothing of an unbounded distribution is asked to be possible


class Parameter(NamedTuple):
    """Key with its distribution, given as an increasing function of a standardised random number, the germ.

    key          name of the key
    written      text of the distribution
    unit         SI unit; "1" for pure numbers
    germ         OpenTURNS distribution of the germ
    logarithmic  True: value = exp(centre + scale germ); False: value = centre + scale germ
    """

    key: str
    written: str
    unit: str
    germ: Any
    logarithmic: bool
    centre: float
    scale: float

    def values(self, germ):
        """Values of the key in SI units, an array, at values of the germ."""
        linear = self.centre + self.scale * numpy.asarray(germ, float)
        return numpy.exp(linear) if self.logarithmic else linear

    def germs(self, probability):
        """Quantiles of the germ, an array, at the given probabilities."""
        return numpy.array([self.germ.computeQuantile(float(p))[0] for p in numpy.ravel(probability)])

    def text(self, value: float) -> str:
        """TOML text of a value in SI units, with the unit."""
        return repr(float(value)) if self.unit == "1" else f'"{float(value)!r} {self.unit}"'


def parse_all(texts, case: Case | None) -> list[Parameter]:
    """Reads Parameters from a list of texts "KEY=DISTRIBUTION" or a dict of key to distribution. Raises CaseError."""
    pairs = list(texts.items()) if isinstance(texts, dict) else [_split(text) for text in texts]
    if not pairs:
        raise CaseError('nothing varies\n  = give at least one --vary "KEY=DISTRIBUTION"; ' + KNOWN)
    for i, (key, _) in enumerate(pairs):
        if key in [other for other, _ in pairs[:i]]:
            raise CaseError(f"{key} varies twice\n  = give one distribution a key")
    return [parse(key, written, case) for key, written in pairs]


def parse(key: str, written: str, case: Case | None) -> Parameter:
    """Reads the distribution of one key. Its numbers have units of the key in the case; without a case (None) they are
    pure.

    Raises CaseError for an unknown distribution, and for one that reaches values that the key cannot have.
    """
    match = CALL.fullmatch(written)
    if not match or match[1].lower() not in FORMS:
        raise CaseError(f"{key}={written}: no distribution\n  = {KNOWN}")
    name, texts = match[1].lower(), [text.strip() for text in match[2].split(",")]
    if len(texts) not in {"triangular": (3,), "normal": (2, 4)}.get(name, (2,)):
        raise CaseError(f"{key}={written}: {len(texts)} numbers\n  = write {FORMS[name]}")
    if case is not None:
        _require_number(key, case)
    parameter = _build(key, written.strip(), name, texts, case)
    if case is not None:
        _require_within(parameter, name, case)
    return parameter


def _split(text: str) -> tuple[str, str]:
    key, equals, written = text.partition("=")
    if not equals or not key.strip():
        raise CaseError(f'{text}: no KEY=DISTRIBUTION\n  = write for instance "contact.friction=uniform(0.1, 0.4)"')
    return key.strip(), written


def _require_number(key: str, case: Case) -> None:
    value = case[key]  # raises for unknown keys, with the nearest
    if not isinstance(value, float):
        raise CaseError(f"{key} = {value!r} is not a single real number, which alone can vary\n"
                        "  = ionskin keys lists every key; of a list name one entry: slider.start[0]")


def quantity(key: str, text: str, case: Case | None) -> tuple[float, str]:
    """Reads one number of a distribution: its value in SI units, and the SI unit; without a case (None), a pure number.

    Raises CaseError.
    """
    if case is not None:
        try:
            return solver.load().key_quantity(key, text)
        except CaseError as error:
            raise CaseError(f"{key}: {error}") from error
    match = NUMBER.fullmatch(text)
    if not match or match[2] or not math.isfinite(float(match[1])):
        raise CaseError(f"{key}: {text!r} is not a number")
    return float(match[1]), "1"


def _deviation(key: str, text: str, mean: float, unit: str, case: Case | None) -> float:
    match = NUMBER.fullmatch(text)
    if match and match[2] == "%":
        result = abs(mean) * float(match[1]) / 100
    else:
        if "%" in text or "percent" in text:
            raise CaseError(f"{key}: the deviation {text} is not understood\n  = write NUMBER % for a share of the mean: 5 %")
        if text.endswith(("degC", "celsius")):
            raise CaseError(f"{key}: {text} is a temperature, no difference of two\n  = give the deviation in K")
        result, own = quantity(key, text, case)
        if own != unit:
            raise CaseError(f"{key}: the deviation {text} is in {own}, the mean in {unit}\n  = give both in one unit, or %")
    if not (math.isfinite(result) and result > 0):
        raise CaseError(f"{key}: the deviation {text} is not above 0\n  = leave a key that does not vary out")
    return result


def _build(key, written, name, texts, case) -> Parameter:
    turns = need("openturns", "ionskin uncertainty")
    first, unit = quantity(key, texts[0], case)

    def made(germ, logarithmic, centre, scale):
        return Parameter(key, written, unit, germ, logarithmic, centre, scale)

    if name in ("normal", "lognormal"):
        deviation = _deviation(key, texts[1], first, unit, case)
        if name == "lognormal":
            if first <= 0:
                raise CaseError(f"{key}: lognormal needs a mean above 0, not {texts[0]}\n  = normal takes any mean")
            variance = math.log1p((deviation / first) ** 2)
            return made(turns.Normal(), True, math.log(first) - variance / 2, math.sqrt(variance))
        if len(texts) == 2:
            return made(turns.Normal(), False, first, deviation)
        ends = _ascending(key, written, [_same_unit(key, text, unit, case) for text in texts[2:]])
        low, high = ((end - first) / deviation for end in ends)
        if low > 6 or high < -6:
            raise CaseError(f"{key}={written}: the range lies more than six deviations from the mean\n"
                            "  = move the mean into the range")
        return made(turns.TruncatedNormal(0.0, 1.0, low, high), False, first, deviation)
    numbers = _ascending(key, written, [first, *(_same_unit(key, text, unit, case) for text in texts[1:])])
    if name == "loguniform":
        if numbers[0] <= 0:
            raise CaseError(f"{key}: loguniform needs ends above 0, not {texts[0]}\n  = uniform takes any")
        numbers = [math.log(number) for number in numbers]
    centre, scale = (numbers[0] + numbers[-1]) / 2, (numbers[-1] - numbers[0]) / 2
    if name == "triangular":
        return made(turns.Triangular(-1.0, (numbers[1] - centre) / scale, 1.0), False, centre, scale)
    return made(turns.Uniform(-1.0, 1.0), name == "loguniform", centre, scale)


def _same_unit(key, text, unit, case) -> float:
    value, own = quantity(key, text, case)
    if own != unit:
        raise CaseError(f"{key}: {text} is in {own}, the first number in {unit}\n  = give all in one unit")
    return value


def _ascending(key, written, numbers) -> list[float]:
    inner = len(numbers) == 3 and numbers[0] <= numbers[1] <= numbers[2]
    if not numbers[0] < numbers[-1] or (len(numbers) == 3 and not inner):
        raise CaseError(f"{key}={written}: the numbers do not ascend\n  = give the lowest first")
    return numbers


def _require_within(parameter: Parameter, name: str, case: Case) -> None:
    """Requires that both ends of a distribution, or its far quantiles, are values that the key can have. Raises CaseError."""
    for probability, end in ((TAIL, "low"), (1 - TAIL, "high")):
        value = float(parameter.values(parameter.germs(probability))[0])
        trial = case.copy()
        trial._edits.pop(parameter.key, None)
        trial._edits[parameter.key] = parameter.text(value)
        try:
            solver.load().check_values(trial)
        except CaseError as error:
            remedy = "give a narrower range"
            if name in ("normal", "lognormal") and parameter.written.count(",") == 1:
                mean, deviation = parameter.written.split("(", 1)[1].rstrip(") ").split(",")
                remedy = (f"truncate it: normal({mean.strip()}, {deviation.strip()}, lowest, highest)" if name == "normal"
                          else "give a smaller deviation, or uniform(lowest, highest)")
            raise CaseError(f"{parameter.key}={parameter.written} reaches values that the key cannot have, at its {end} end: "
                            f"{value:.6g}{'' if parameter.unit == '1' else ' ' + parameter.unit}\n  = {remedy}\n{error}") from error
