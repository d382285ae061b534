another-arm-answers = Another arm responds at { $url }: { $name } { $serial_number } ({ $joints } joints) instead of { $expected_name } { $expected_serial_number }
arm-announced-joints-sends-poses = The arm at { $url } announced joints, but sends poses
arm-closed-while-opening = The arm at { $url } was closed while it was being opened
arm-counts-pulses-from-start-again = The arm at { $url } restarted while the camera counted its trigger pulses
arm-does-not-answer-pulse-request = The arm at { $url } has trigger pulses, but does not answer a request to start or stop them
arm-has-joints-station-toml-asks = The arm at { $url } ({ $name } { $serial_number }) has { $joints } joints, but station.toml states joint_count = { $joint_count }
arm-has-no-trigger-pulses = The arm at { $url } has no output for trigger pulses
arm-not-open = The arm at { $url } is not open
arm-poses-other-setting = The poses of the arm at { $url } are in the setting { $setting } of tool and coordinate system instead of { $expected }
arm-refuses-pulse-rate = The arm at { $url } cannot trigger at { $rate }
arm-reports-joints =
    The arm at { $url } reports { $joints ->
        [one] { $joints } joint
       *[other] { $joints } joints
    }
arm-reports-no-counts-per-revolution = The arm at { $url } reports 0 counts per revolution for joint { $joint }
arm-sends-hello-but-no-samples = The arm at { $url } sends its hello ({ $name }) but no samples
arm-sends-no-valid-poses = The last { $count } poses of the arm at { $url } contain a number that is not finite, or a quaternion that is not of length 1
arm-sends-other-joint-count = The arm at { $url } announced { $expected } joints, but sends { $count }
arm-sends-samples-but-no-hello = The arm at { $url } sends samples but no hello
arm-speaks-version-protocol-driver-speaks = The arm at { $url } uses version { $other_version } of the protocol; this driver supports versions 1 and 2
arm-url-cannot-be-opened = The arm's url { $url } cannot be opened ({ $reason })
arms-5-6-7-joints-served = Arms with 5, 6 or 7 joints are supported.
arms-adapter-running = Check that the arm's adapter is running.
bridge-must-send-finite-unit-quaternions = Its bridge must send unit quaternions, and nothing while the pose is unknown.
bytes-but-no-packet =
    { $count ->
        [one] { $count } byte arrived from { $url }, but no packet of an encoder arm
       *[other] { $count } bytes arrived from { $url }, but no packet of an encoder arm
    }
check-address-network = Check its address and its network.
check-arm-power-and-no-second-program = Check the arm's power supply, and that no other program starts its pulses.
check-arm-url = Check the arm's url.
check-baud-rate-arm-port-another = Check the baud rate, and that the device on this port is the arm.
check-robot-network = Check that the robot's controller is on, its address, the network cable and firewalls.
check-which-arm-plugged = Check which arm is connected.
choose-pulse-rate = Choose a rate from { $low } to { $high }.
close-program-second-station-same-port = Close that program, or the other station that uses this port.
driver-bridge = Encoder arm or bridge, on a serial port or the network
driver-microscribe = MicroScribe arm
enter-device-address = Enter a device path as /dev/ttyUSB0, a port as COM5, socket://HOST:PORT or rfc2217://HOST:PORT.
enter-network-address-as = For an address in the network, enter { $url }.
firmware-must-answer-hello = Its firmware must answer the hello request (crenel_hardware.arm.protocol).
firmware-must-answer-pulse-request = Its firmware must answer pulse requests (crenel_hardware.arm.protocol).
firmware-must-send-counts-of-hello = Its firmware must send as many counts as its hello announces.
firmware-must-send-what-hello-announces = Its firmware must send what its hello announces.
give-one-number-all-joints-one = Give one number for all joints, or one for each joint.
host-not-known = The host in { $url } is not known
it-is-no-device = it is not the address of a device
line-to-arm-closed = The connection to the arm at { $url } is closed
line-to-arm-gone = The connection to the arm at { $url } was lost
line-to-arm-lost = The connection to the arm at { $url } was lost ({ $reason })
linux-add-user-group-owns-port = On Linux, add the user to the group that owns the port (often dialout).
microscribe-needs-five-joints = This driver serves MicroScribe arms with five joints only.
microscribe-no-answer = No MicroScribe answers at { $url }
microscribe-other-device = The device at { $url } does not answer as a MicroScribe does
microscribe-stopped-answering = The MicroScribe at { $url } has stopped answering
no-answer-from = { $url } does not respond
no-serial-port-named = There is no serial port { $url }
no-serial-port-plugged = No serial port is connected.
nothing-came-for = No data arrived from { $url } for { $time }
nothing-can-be-sent-to-arm = No data can be sent to the arm at { $url } ({ $reason })
nothing-listens = No program listens at { $url }
option-counts-per-revolution = Counts per revolution
option-help-setting = Number of tool and coordinate system that the bridge sends; poses with another number are refused
option-joint-count = Number of joints
option-setting = Setting of the poses
plug-right-arm-correct-arm-joint = Connect the right arm, or correct [arm] joint_count.
ports-are = Available ports: { $names }.
restart-robot-controller = Restart the controller of the arm.
restore-tool-and-coordinate-system = Select the former tool and coordinate system at the arm, or calibrate with the new ones.
robot-clock-jumped = The clock of the arm at { $address } has jumped: its controller was restarted or its time was set
serial-port-use-another-program = The serial port { $url } is in use by another program
set-arm-counts-per-revolution-station = Set [arm] counts_per_revolution in station.toml.
station-toml-gives-counts-per-revolution = station.toml gives { $counts } counts_per_revolution, but the arm has { $joints } joints
switch-arm-check-cable-port = Switch on the arm, and check its cable and the port.
switch-arm-off = Switch the arm off and on.
trigger-camera-otherwise = Connect an arm with a trigger output, or let the camera run freely.
update-program-arms-firmware = Update this program or the arm's firmware.
user-may-not-open-serial-port = This user may not open the serial port { $url }, or another program uses it
