ui-address = Adresse
ui-back-up-now = Jetzt sichern
ui-backup = Sicherung
ui-backup-copies-calibrations-scans-accounts-settings = Eine Sicherung kopiert Kalibrierungen, Scans, Konten und Einstellungen im laufenden Betrieb. Zum Wiederherstellen die Station beenden und mit diesem Ordner neu starten:
ui-browser-displays-notifications-only-over-https = Dieser Browser zeigt Benachrichtigungen nur über HTTPS oder direkt an der Station an. In station.toml tls_certificate und tls_key angeben.
ui-by-webhook = Per Webhook
ui-completed-jobs-faults-due-calibrations-also = Fertige Aufträge, Störungen und fällige Kalibrierungen werden auch gemeldet, wenn ein anderes Fenster im Vordergrund ist.
ui-copying = Wird kopiert …
ui-create-token = Token anlegen
ui-done-scan-saved-calibration-accepted = Erledigt: Scan gespeichert, Kalibrierung angenommen
ui-due-a-calibration-is-too-old = Fällig: Eine Kalibrierung ist zu alt
ui-enter-program-appears-only-once = Im Programm eintragen. Der Token wird nur einmal angezeigt:
ui-errors = Fehler
ui-everything-is-in-order = Alles in Ordnung
ui-fault-device-lost-recording-failed = Störung: Geräteverbindung unterbrochen, Aufzeichnung fehlgeschlagen
ui-files = { $n ->
        [one] { $n } Datei
       *[other] { $n } Dateien
    }
ui-in-this-browser = In diesem Browser
ui-items-need-attention = { $n ->
        [one] Ein Punkt ist zu beachten
       *[other] { $n } Punkte sind zu beachten
    }
ui-last-backup = Letzte Sicherung { $when }: { $files }, { $size } in { $folder }
ui-less = Weniger
ui-loading = Wird geladen …
ui-log = Protokoll
ui-log-level = Stufe
ui-log-lines = Protokollzeilen
ui-messages-delivered = { $n ->
        [one] { $n } Nachricht zugestellt
       *[other] { $n } Nachrichten zugestellt
    }
ui-metrics = Metriken
ui-n-waiting = { $n ->
        [one] { $n } wartet
       *[other] { $n } warten
    }
ui-name-of-the-program = Name des Programms
ui-new-address-requires-secret-again = Für eine neue Adresse muss das Geheimnis erneut eingegeben werden.
ui-new-token = Neuer Token
ui-no-backup-yet = Noch keine Sicherung. Sicherungen werden in { $folder } geschrieben
ui-no-log-line-matches = Keine Protokollzeile passt dazu.
ui-not-delivered = Nicht zugestellt: { $reason }
ui-nothing-sent-yet = Noch nichts gesendet
ui-notification-sent-json-post-signed-hmac = Jede Benachrichtigung wird als JSON per POST gesendet und im Header Crenel-Signature mit HMAC-SHA256 signiert. Fehlgeschlagene Zustellungen werden wiederholt.
ui-notifications = Benachrichtigungen
ui-notifications-blocked-browser-allow-them-icon = Benachrichtigungen sind in diesem Browser blockiert. Über das Symbol neben der Adresse erlauben.
ui-one-file-support-checks-versions-settings = Eine Datei für den Support: Prüfungen, Versionen, Einstellungen, Protokoll und die letzten Schritte. Sie enthält keine Passwörter, Token, Schlüssel oder Namen. Es wird nichts gesendet.
ui-only-an-administrator-can-make-backups = Nur ein Administrator kann Sicherungen anlegen.
ui-open-the-reference = Referenz der HTTP-Schnittstelle öffnen
ui-problems = { $n ->
        [one] Ein Problem
       *[other] { $n } Probleme
    }
ui-prometheus-reads = Prometheus liest { $address } mit einem eigenen Token, gesendet als Bearer.
ui-revoke-this-token = Diesen Token widerrufen
ui-save-the-support-bundle = Diagnosepaket speichern
ui-secret = Geheimnis
ui-set-it-is-not-displayed-again = gesetzt; wird nicht erneut angezeigt
ui-source-in-the-program = Stelle im Programm
ui-support-bundle = Diagnosepaket
ui-test = Testen
ui-turn-off-notifications-here = Benachrichtigungen hier ausschalten
ui-turn-on-notifications-here = Benachrichtigungen hier einschalten
ui-warnings = Warnungen
