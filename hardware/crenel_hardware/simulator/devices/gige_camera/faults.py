"""What goes wrong with the camera and its cable on purpose."""

from dataclasses import dataclass, field


@dataclass
class GigeFaults:
    """Set at any time, from any thread."""

    unplugged: bool = False
    """The cable, which also supplies the camera, is pulled."""
    packet_drop_rate: float = 0.0
    """Share of the stream's packets that get lost on the line, 0 to 1; also of those sent again."""
    lost_packets: frozenset[tuple[int, int]] = field(default_factory=frozenset)
    """Block ids and packet numbers that get lost once."""
    resends: bool = True
    """False: a camera that cannot send packets again."""
    taken: bool = False
    """Another program has taken the camera, and lets no other read or write."""
    line_bytes_per_s: float | None = None
    """A line slower than the camera's own."""
    unanswered: int = 0
    """So many of the next requests get no answer."""
    answered: int = 0
    """So many are answered before those."""
    latch_delays_s: tuple[float, ...] = ()
    """How late the camera answers that it has latched its clock, in turn."""

    def clear(self) -> None:
        """Everything works again."""
        self.unplugged = self.taken = False
        self.packet_drop_rate, self.lost_packets = 0.0, frozenset()
        self.resends, self.line_bytes_per_s = True, None
        self.unanswered, self.answered, self.latch_delays_s = 0, 0, ()
