devices-cannot-be-changed-now = Devices cannot be changed now
extraction-detection = Extraction and detection
guided-session-is-open =
    a guided session is open on the page { $kind ->
        [calibration] “Calibrate”
        [verification] “Verify”
        [performance] “Performance”
        [inspection] “Part”
       *[arm] “Arm & tip”
    }
guided-steps = Guided steps
image-processing = Image processing
listen-choose-higher-port = Choose a port from 1024 on with --port
listen-failed = Cannot listen on { $host } port { $port }
listen-free-port = Stop what is using it, or choose another with --port
listen-give-own-address = Give an address of this machine with --host
more-than-kb-were-sent = The request is larger than { $limit }.
n-3d-view = 3D view
no-page-file-has-such-address = No page or file has this address.
numerics = Numerics
only-stations-own-pages-may-do = Only the server's own pages may do this.
proxy-changes-host = The page is at { $page }, but its request came here for { $host }.
proxy-does-not-pass-upgrade = A live connection arrived without its upgrade: a proxy does not pass on WebSockets.
proxy-list-it = If it is your proxy, add its address to proxies in the settings.
proxy-not-listed = X-Forwarded-Prefix from { $address } is not used: no listed proxy has this address.
proxy-pass-host = If a proxy is in front of the server, let it pass on the browser's Host; in nginx: proxy_set_header Host $http_host;
proxy-pass-upgrade = Let the proxy pass on the upgrade; in nginx: proxy_http_version 1.1; proxy_set_header Upgrade $http_upgrade; proxy_set_header Connection $http_connection;
proxy-sub-path-unusable = X-Forwarded-Prefix of the proxy is not used: it is no sub-path.
recording-has-no-joints = { $path }: no arm readings
replay-points-shown =
    { $count ->
        [one] { $name }: { $count } point shown
       *[other] { $name }: { $count } points shown
    }
request-did-not-arrive = The request did not arrive within { $limit }.
settings-are-lost = The settings were lost: { $error }
station-does-not-answer-to-name = This server does not respond to the name '{ $name }'. Add names with hosts in { $file }.
station-starting = The station is starting.
tls-give-own-key = Give the certificate with its chain, and its own key
tls-give-plain-key = Give the key without a password, readable only by the station
tls-key-encrypted-nobody-to-ask = it is encrypted, and there is nobody to enter its password
tls-key-unusable = { $file } cannot be used
tls-no-pair = they are not a certificate and its key in PEM format
tls-no-pair-reason = they are not a certificate and its key in PEM format ({ $reason })
tls-pair-unusable = { $certificate } and { $key } cannot be used
try-again-moment = Try again in a moment
