devices-cannot-be-changed-now = Die Geräte können jetzt nicht geändert werden
extraction-detection = Extraktion und Erkennung
guided-session-is-open =
    auf der Seite { $kind ->
        [calibration] „Kalibrieren“
        [verification] „Verifizieren“
        [performance] „Leistung“
        [inspection] „Teil“
       *[arm] „Messarm und Tastkugel“
    } ist eine geführte Sitzung offen
guided-steps = Geführte Schritte
image-processing = Bildverarbeitung
listen-choose-higher-port = Mit --port einen Port ab 1024 wählen
listen-failed = Port { $port } von { $host } lässt sich nicht öffnen
listen-free-port = Beenden, was ihn verwendet, oder mit --port einen anderen wählen
listen-give-own-address = Mit --host eine Adresse dieses Rechners angeben
more-than-kb-were-sent = Die Anfrage ist größer als { $limit }.
n-3d-view = 3D-Ansicht
no-page-file-has-such-address = Unter dieser Adresse gibt es keine Seite und keine Datei.
numerics = Numerik
only-stations-own-pages-may-do = Das dürfen nur die Seiten dieses Servers.
proxy-changes-host = Die Seite ist unter { $page }, aber ihre Anfrage kam hier für { $host } an.
proxy-does-not-pass-upgrade = Eine Live-Verbindung kam ohne ihr Upgrade an: Ein Proxy reicht WebSockets nicht weiter.
proxy-list-it = Wenn es Ihr Proxy ist, seine Adresse in den Einstellungen unter proxies eintragen.
proxy-not-listed = X-Forwarded-Prefix von { $address } wird nicht verwendet: Kein eingetragener Proxy hat diese Adresse.
proxy-pass-host = Steht ein Proxy vor dem Server, soll er den Host des Browsers weiterreichen; in nginx: proxy_set_header Host $http_host;
proxy-pass-upgrade = Der Proxy soll das Upgrade weiterreichen; in nginx: proxy_http_version 1.1; proxy_set_header Upgrade $http_upgrade; proxy_set_header Connection $http_connection;
proxy-sub-path-unusable = X-Forwarded-Prefix des Proxys wird nicht verwendet: Es ist kein Unterpfad.
recording-has-no-joints = { $path }: keine Messwerte eines Messarms
replay-points-shown =
    { $count ->
        [one] { $name }: { $count } Punkt angezeigt
       *[other] { $name }: { $count } Punkte angezeigt
    }
request-did-not-arrive = Die Anfrage ist nicht innerhalb von { $limit } angekommen.
settings-are-lost = Die Einstellungen sind verloren: { $error }
station-does-not-answer-to-name = Dieser Server ist unter dem Namen „{ $name }“ nicht erreichbar. Namen lassen sich mit hosts in { $file } ergänzen.
station-starting = Die Station startet.
tls-give-own-key = Das Zertifikat mit seiner Kette und den dazugehörigen Schlüssel angeben
tls-give-plain-key = Den Schlüssel ohne Passwort angeben, lesbar nur für die Station
tls-key-encrypted-nobody-to-ask = er ist verschlüsselt, und niemand ist da, der sein Passwort eingibt
tls-key-unusable = { $file } lässt sich nicht verwenden
tls-no-pair = sie sind kein Zertifikat mit seinem Schlüssel im PEM-Format
tls-no-pair-reason = sie sind kein Zertifikat mit seinem Schlüssel im PEM-Format ({ $reason })
tls-pair-unusable = { $certificate } und { $key } lassen sich nicht verwenden
try-again-moment = Gleich noch einmal versuchen
