"""Contact points on the target, and the target's frame in the arm.

Entry points: ``alignment.align`` fits the block's faces to contact points;
``alignment.refuse_wrong_faces`` refuses those that lie on another face than labelled;
``contacts.missing_contacts`` says what is still to be probed.
"""
