"""The states and bodies that reports name, and their findings as objects."""

import enum
from dataclasses import dataclass
from typing import Optional, Tuple

Vector = Tuple[float, float, float]


class State(enum.IntEnum):
    """The state of a move: the values of Report.state, Depths.state and Finding.state."""

    CLEAN = 0
    NEAR = 1  #: nearer than near_miss
    GOUGE = 2
    BURIED = 3  #: inside a solid with no surface inside the tool
    NOT_CHECKED = 4  #: see Report.reason
    NOT_CERTIFIED = 5  #: not proved within the budget


class Body(enum.IntEnum):
    """The body of the tool that is nearest to a witness: the values of Report.body, Depths.body and Finding.body."""

    CUTTER = 0
    SHANK = 1
    HOLDER = 2
    HEAD = 3


@dataclass(frozen=True)
class Finding:
    """Neighbouring moves with one cause, or all moves that are open for one reason; lengths in mm.

    The data are those of the worst move, or of the first one if it was not checked. tip and axis: the tool at the
    instant t of the witness, or at the end of the move. None stands for what is not known.
    """

    state: State
    line: int  #: in the file; of a path from memory the number of the move, from 1
    move: int  #: index into the arrays of the report
    moves: int
    depth: Optional[float]
    depth_upper: Optional[float]
    overcut: Optional[float]
    clearance: Optional[float]  #: distance of a near miss
    body: Optional[Body]
    against: str  #: name of the mesh, or 'stock'
    tool: str  #: its number, else its name
    operation: str
    t: Optional[float]
    tip: Vector
    axis: Vector
    point: Optional[Vector]
    normal: Optional[Vector]
    message: str

    def __post_init__(self) -> None:
        object.__setattr__(self, "state", State(self.state))
        # Takes away the quotes that a label of a tool has.
        object.__setattr__(self, "tool", self.tool.strip('"'))
        if self.body is not None:
            object.__setattr__(self, "body", Body(self.body))

    def __str__(self) -> str:
        return f"line {self.line}: {self.message}"


for _type in (State, Body, Finding):
    _type.__module__ = "gougecheck"
