"""What the errors of stores' libraries mean."""

import pytest

from crenel.archive.store_errors import StoreError, convert_store_errors


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Could not connect to the endpoint URL: http://127.0.0.1:45507/clouds", "archive-away"),
        ("An error occurred (507) when calling PutObject", "archive-full"),
        ("An error occurred (QuotaExceeded) when calling PutObject", "archive-full"),
    ],
)
def test_a_number_in_an_address_is_no_full_store(text: str, code: str) -> None:
    with pytest.raises(StoreError) as refused, convert_store_errors("s3://clouds"):
        raise OSError(text)
    assert refused.value.code == code
