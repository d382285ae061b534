"""A simulated station: arm, sensor, table with gauges, and an operator that moves them.

It stands in for nature, so it shares no code and no types with the solver: a wrong
formula on one side cannot cancel itself out on the other.
"""
