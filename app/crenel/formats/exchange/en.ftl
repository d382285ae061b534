install-extra-xlsx = Install it with: pip install 'crenel[xlsx]'; or use CSV
schema-error = line { $line }: { $error }
schema-errors-more =
    { $count ->
        [one] and one more error
       *[other] and { $count } more errors
    }
schema-fetch = put { $name } into { $folder }
schema-imports-missing = it includes or imports { $location }, which is not there, and nothing is fetched
schema-is-none = it is not an XML schema (XSD)
schema-not-complied-with = the file would not comply with { $schema }: { $errors }
schema-nothing-written = nothing was written
schema-package-missing = validation requires the package lxml, which is not installed
schema-unusable = the schema cannot be used: { $error }
xlsx-extra-missing = Needs XlsxWriter on the station: pip install 'crenel[xlsx]'
xlsx-package-missing = XLSX files require the package XlsxWriter, which is not installed
