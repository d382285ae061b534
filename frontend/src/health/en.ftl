ui-address = Address
ui-back-up-now = Back up now
ui-backup = Backup
ui-backup-copies-calibrations-scans-accounts-settings = A backup copies calibrations, scans, accounts and settings while the station runs. To restore a backup, stop the station and start it with the backup folder:
ui-browser-displays-notifications-only-over-https = This browser shows notifications only over HTTPS, or on the station itself. For HTTPS, set tls_certificate and tls_key in station.toml.
ui-by-webhook = By webhook
ui-completed-jobs-faults-due-calibrations-also = Notifies you when a job is done, a fault occurs or a calibration is due, even when another window is in front.
ui-copying = Copying…
ui-create-token = Create token
ui-done-scan-saved-calibration-accepted = Done: a scan is saved, a calibration is accepted
ui-due-a-calibration-is-too-old = Due: a calibration is too old
ui-enter-program-appears-only-once = Enter this token in the program. It appears only once:
ui-errors = Errors
ui-everything-is-in-order = Everything is OK
ui-fault-device-lost-recording-failed = Fault: a device is lost, a recording has failed
ui-files = { $n ->
        [one] { $n } file
       *[other] { $n } files
    }
ui-in-this-browser = In this browser
ui-items-need-attention = { $n ->
        [one] One item needs attention
       *[other] { $n } items need attention
    }
ui-last-backup = Last backup { $when }: { $files }, { $size } in { $folder }
ui-less = Less
ui-loading = Loading…
ui-log = Log
ui-log-level = Level
ui-log-lines = Log lines
ui-messages-delivered = { $n ->
        [one] { $n } message delivered
       *[other] { $n } messages delivered
    }
ui-metrics = Metrics
ui-n-waiting = { $n ->
        [one] { $n } waiting
       *[other] { $n } waiting
    }
ui-name-of-the-program = Name of the program
ui-new-address-requires-secret-again = If you change the address, enter the secret again.
ui-new-token = New token
ui-no-backup-yet = No backup yet. Backups go to { $folder }
ui-no-log-line-matches = No log line matches.
ui-not-delivered = Not delivered: { $reason }
ui-nothing-sent-yet = Nothing sent yet
ui-notification-sent-json-post-signed-hmac = The station sends each notification as JSON by POST, signed with HMAC-SHA256 in the header Crenel-Signature, and retries failed deliveries.
ui-notifications = Notifications
ui-notifications-blocked-browser-allow-them-icon = Notifications are blocked in this browser. Allow them with the icon next to the address.
ui-one-file-support-checks-versions-settings = One file for support: checks, versions, settings, log and recent steps. It contains no passwords, tokens, keys or names. Nothing is sent.
ui-only-an-administrator-can-make-backups = Only an administrator can make backups.
ui-open-the-reference = Open the reference of the HTTP interface
ui-problems = { $n ->
        [one] One problem
       *[other] { $n } problems
    }
ui-prometheus-reads = Prometheus reads { $address } with its own token, sent as a Bearer token.
ui-revoke-this-token = Revoke this token
ui-save-the-support-bundle = Save the support bundle
ui-secret = Secret
ui-set-it-is-not-displayed-again = set; not shown again
ui-source-in-the-program = Source in the program
ui-support-bundle = Support bundle
ui-test = Test
ui-turn-off-notifications-here = Turn off notifications here
ui-turn-on-notifications-here = Turn on notifications here
ui-warnings = Warnings
