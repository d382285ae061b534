"""What can go wrong on purpose: switches that a test or a curious operator turns."""

from dataclasses import dataclass


@dataclass
class Faults:
    """Set at any time, from any thread. Rates are shares of packets or frames, 0 to 1."""

    drop_rate: float = 0.0
    """Samples taken and never sent."""
    corrupt_rate: float = 0.0
    """Samples sent with a wrong byte."""
    garbage_rate: float = 0.0
    """Samples with random bytes before them."""
    late_rate: float = 0.0
    """Samples that hold up the line for ``late_s``; what follows waits behind them."""
    late_s: float = 0.1
    stalled: bool = False
    """The arm goes on measuring, and sends nothing."""
    unplugged: bool = False
    """The arm's line is gone; it comes back at the same address."""
    frozen_joint: int | None = None
    """Its encoder says what it said when this was set, again and again."""
    odd_joint: int | None = None
    """Its encoder is off by ``odd_rad`` in one of every ``odd_every`` samples."""
    odd_rad: float = 0.0
    odd_every: int = 1
    camera_lost: bool = False
    frame_drop_rate: float = 0.0
    """Frames taken and never delivered."""

    def clear(self) -> None:
        """Everything works again."""
        for name, value in Faults().__dict__.items():
            setattr(self, name, value)
