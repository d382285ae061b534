check-address-and-port = Check the address and the port in station.toml.
driver-ur-rtde = Robot of Universal Robots (RTDE)
robot-said = { $text }. The robot reports: { $said }
ur-arm-off = The joints of the robot at { $address } are without power; their angles are not measured
ur-does-not-speak-rtde-2 = The robot at { $address } does not speak version 2 of RTDE
ur-has-not = The robot at { $address } does not offer { $names }
ur-keep-tool = Keep one active tool during a session. The connection opens again by itself; then repeat the last action.
ur-no-answer = The robot at { $address } accepts the connection but does not answer as RTDE does
ur-no-rtde = What arrives from { $address } is no RTDE ({ $reason })
ur-rate-too-high = The robot at { $address } sends at most { $fastest }, but station.toml states { $rate }
ur-refuses-start = The robot at { $address } refuses to send data
ur-switch-on = Switch the robot arm on at its teach pendant.
ur-tool-changed = The active tool (TCP) of the robot at { $address } was changed
ur-update-polyscope = Update PolyScope, the robot's software, to 3.12 (CB3) or 5.5.1 (e-Series) or later; on older software, use report = "joints".
