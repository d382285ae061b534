"""Maximum permissible errors, as datasheets state them."""

from dataclasses import dataclass


@dataclass(frozen=True)
class PermissibleError:
    """``A``, or ``A + L/K`` up to ``B``, in µm with L in mm."""

    a_um: float
    k: float | None = None
    """Dimensionless; the error grows by L/K."""
    b_um: float | None = None
    """The cap."""

    def at(self, length_mm: float = 0.0) -> float:
        """The limit in µm for a length.

        Source:
            The forms of ISO 10360-2, -9 and -12.

        Example:
            >>> PermissibleError(20.0, 40.0, 40.0).at(400.0)
            30.0
            >>> PermissibleError(20.0, 40.0, 40.0).at(4000.0)
            40.0
        """
        limit = self.a_um + (length_mm / self.k if self.k else 0.0)
        return limit if self.b_um is None else min(limit, self.b_um)
