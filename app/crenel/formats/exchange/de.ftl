install-extra-xlsx = Mit pip install 'crenel[xlsx]' installieren oder CSV verwenden
schema-error = Zeile { $line }: { $error }
schema-errors-more =
    { $count ->
        [one] und ein weiterer Fehler
       *[other] und { $count } weitere Fehler
    }
schema-fetch = { $name } nach { $folder } legen
schema-imports-missing = es bindet { $location } ein, und diese Datei fehlt; aus dem Netz wird nichts geladen
schema-is-none = das ist kein XML-Schema (XSD)
schema-not-complied-with = die Datei entspräche nicht { $schema }: { $errors }
schema-nothing-written = es wurde nichts geschrieben
schema-package-missing = die Prüfung benötigt das Paket lxml, das nicht installiert ist
schema-unusable = das Schema ist nicht verwendbar: { $error }
xlsx-extra-missing = Braucht XlsxWriter auf der Station: pip install 'crenel[xlsx]'
xlsx-package-missing = XLSX-Dateien benötigen das Paket XlsxWriter, das nicht installiert ist
