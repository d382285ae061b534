"""The simulated station's room, which an air conditioner keeps within half a degree."""

import math
import time

MEAN_C, SWING_C, PERIOD_S = 21.4, 0.4, 1500.0


class RoomThermometer:
    """Reads to a hundredth of a degree."""

    def read_c(self) -> float:
        return round(MEAN_C + SWING_C * math.sin(2 * math.pi * time.time() / PERIOD_S), 2)
