"""MicroScribe arms, read by the serial protocol of their Immersion HCI."""
