"""What a number refuses that has no value: comparisons, conversions, and functions that are not smooth."""

from typing import Any, NoReturn

from actio._refusals import refuse, refuse_branch, refuse_corner, refuse_float, refuse_whole


class WithoutValue:
    """A number that has no value, or none yet."""

    __slots__ = ()
    __hash__ = object.__hash__

    def __bool__(self) -> bool:
        refuse_branch("whether a number is true is asked")

    def __lt__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by <")

    def __le__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by <=")

    def __gt__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by >")

    def __ge__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by >=")

    def __eq__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by ==")

    def __ne__(self, other: Any) -> bool:
        refuse_branch("numbers are compared by !=")

    def __float__(self) -> float:
        refuse_float()

    def __complex__(self) -> complex:
        refuse("a complex number is needed here, and a Lagrangian is real")

    def __index__(self) -> int:
        refuse_whole()

    __int__ = __index__

    # ---- What is not smooth

    def __round__(self, digits: Any = None) -> NoReturn:
        refuse_corner("round")

    def __floor__(self) -> NoReturn:
        refuse_corner("floor")

    def __ceil__(self) -> NoReturn:
        refuse_corner("ceil")

    def __trunc__(self) -> NoReturn:
        refuse_corner("trunc")

    def __floordiv__(self, other: Any) -> NoReturn:
        refuse_corner("//")

    __rfloordiv__ = __floordiv__

    def __mod__(self, other: Any) -> NoReturn:
        refuse_corner("%")

    __rmod__ = __mod__

    def __divmod__(self, other: Any) -> NoReturn:
        refuse_corner("divmod")

    __rdivmod__ = __divmod__
