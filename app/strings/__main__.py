"""``python -m app.strings``: brings the files up to what the code says.

English is written anew. Of another language what is no longer said is left out, and what is
still to be translated is told.
"""

from app.strings.collect import collect_texts
from app.strings.files import ENGLISH, languages, load_strings, write


def main() -> None:
    texts = collect_texts()
    write(ENGLISH, {text: text for text in texts})
    for language in languages()[1:]:
        known = load_strings(language)
        write(language, {text: known[text] for text in texts if text in known})
        missing = [text for text in texts if text not in known]
        print(f"{language}: {len(texts) - len(missing)} of {len(texts)} texts")
        for text in missing:
            print(f"  {text}")


if __name__ == "__main__":
    main()
