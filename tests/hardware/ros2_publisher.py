"""A node of ROS 2 that publishes joints and poses; commands come by standard input.

``silent``, ``loud``, ``unstamped``, ``moved`` (another frame), ``nan``, ``short`` (a joint fewer)
and ``earlier`` (the clock goes back).
"""

import sys
import threading
import time
from typing import Any

RATE_HZ = 250
JOINTS = ["joint_b", "joint_a", "joint_c", "joint_e", "joint_d", "joint_f", "gripper"]


def publish() -> None:
    import rclpy
    from geometry_msgs.msg import PoseStamped
    from rclpy.qos import qos_profile_sensor_data
    from rclpy.time import Time
    from sensor_msgs.msg import JointState

    said: set[str] = set()
    threading.Thread(target=listen, args=(said,), daemon=True).start()
    rclpy.init()
    node = rclpy.create_node("bench_arm")
    joints = node.create_publisher(JointState, "/bench/joints", 100)
    transforms = transform_publishers(node)
    poses = node.create_publisher(PoseStamped, "/bench/pose", qos_profile_sensor_data)
    start_ns, sent = time.monotonic_ns(), 0
    first_ns = node.get_clock().now().nanoseconds
    while True:
        time.sleep(0.001)
        while (time.monotonic_ns() - start_ns) * RATE_HZ > sent * 1_000_000_000:
            sent += 1
            # when it was due, as a controller measures: a busy machine sends it later
            stamp = Time(nanoseconds=first_ns + sent * 1_000_000_000 // RATE_HZ).to_msg()
            if "silent" not in said:
                joints.publish(stamped(joint_state(JointState(), said), stamp, said))
                poses.publish(stamped(pose(PoseStamped(), said), stamp, said))
                if transforms is not None:
                    transforms(stamp)


def transform_publishers(node: Any) -> Any:
    """Publishes base -> flange at each call, and flange -> tool, which is the same place, once;
    None without tf2_msgs."""
    try:
        from tf2_msgs.msg import TFMessage
    except ImportError:
        return None
    from geometry_msgs.msg import TransformStamped
    from rclpy.qos import DurabilityPolicy, QoSProfile

    def made(parent: str, child: str, stamp: Any) -> Any:
        one = TransformStamped()
        one.header.frame_id, one.child_frame_id, one.header.stamp = parent, child, stamp
        if child == "flange":
            moved, turned = one.transform.translation, one.transform.rotation
            moved.x, moved.y, moved.z = 0.5, -0.25, 0.125
            turned.x, turned.w = 0.6, 0.8
        return TFMessage(transforms=[one])

    moving = node.create_publisher(TFMessage, "/tf", 100)
    kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    static = node.create_publisher(TFMessage, "/tf_static", kept)
    static.publish(made("flange", "tool", node.get_clock().now().to_msg()))
    return lambda stamp: moving.publish(made("base", "flange", stamp))


def listen(said: set[str]) -> None:
    for line in sys.stdin:
        said.add(line.strip())
        if line.strip() == "loud":
            said.clear()


def stamped(made: Any, stamp: Any, said: set[str]) -> Any:
    if "unstamped" not in said:
        made.header.stamp = stamp
    if "earlier" in said:
        made.header.stamp.sec -= 3600
    made.header.frame_id = "elsewhere" if "moved" in said else "base"
    return made


def joint_state(state: Any, said: set[str]) -> Any:
    first = 1 if "short" in said else 0
    state.name = JOINTS[first:]
    state.position = [float("nan") if "nan" in said else 0.1 * at for at in range(first, 7)]
    return state


def pose(made: Any, said: set[str]) -> Any:
    made.pose.position.x, made.pose.position.y = 0.5, -0.25
    made.pose.position.z = float("nan") if "nan" in said else 0.125
    made.pose.orientation.x, made.pose.orientation.w = 0.6, 0.8
    return made


if __name__ == "__main__":
    publish()
