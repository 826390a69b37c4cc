"""Arguments: what is wrong with one is a ValueError that names it, its value and the remedy."""

import operator
import sys
from typing import Any, List

import numpy


def vector(name: str, value: Any) -> List[Any]:
    try:
        numbers = list(value)
    except TypeError:
        numbers = []
    if len(numbers) != 3 or isinstance(value, str):
        raise ValueError(f"{name}: {value!r} is not three numbers")
    return numbers


def finite(name: str, value: Any) -> float:
    largest = sys.float_info.max
    try:
        return number(name, value, -largest, largest)
    except ValueError:
        raise ValueError(f"{name}: {value!r} is not a finite number") from None


def whole_number(name: str, value: Any, low: int, high: float = float("inf")) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise ValueError(f"{name}: {value!r} is not a whole number") from None
    return in_range(name, number, low, high)


def number(name: str, value: Any, low: float, high: float = float("inf")) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: {value!r} is not a number") from None
    return in_range(name, number, low, high)


def in_range(name, number, low, high):
    # Written so that NaN is out of range, and infinity is where there is no upper end.
    if not (low <= number <= high and number < float("inf")):
        until = "or more" if high == float("inf") else f"to {high:.10g}"
        raise ValueError(f"{name}: {number} is out of range; give {low:g} {until}")
    return number


def one_of(name: str, value: Any, known: Any) -> Any:
    if value not in list(known):
        raise ValueError(f"{name}: {value!r} is not known; there are {', '.join(known)}")
    return value


def flag(name, value):
    if not isinstance(value, (bool, numpy.bool_)):
        raise ValueError(f"{name}: {value!r} is not True or False")
    return bool(value)
