"""Contact points on the target, and the target's frame in the arm.

Entry points: ``alignment.align`` fits the block's faces to contact points;
``alignment.refuse_wrong_faces`` refuses those on a face other than the labelled one;
``contacts.missing_contacts`` lists what is still to be probed.
"""
