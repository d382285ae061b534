"""A block for a sensor: its shape, and the accuracy that calibrations with it will have.

Entry point: ``propose_block.propose_block``. In the order in which it uses them: ``stripe_sensor``,
``merlon_widths``, ``usual_arm``, ``expected_contacts``, ``expected_accuracy``,
``making_tolerance``.
"""
