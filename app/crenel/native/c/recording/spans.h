/* Reading a stretch of foreign bytes from front to back, never beyond its end.
 *
 * Every function that takes something returns false where it is not there; nothing is to be read
 * from the span after that. Numbers of more than 63 bits count as not there. */
#ifndef CRENEL_SPANS_H
#define CRENEL_SPANS_H

#include "../export.h"

typedef struct {
    const uint8_t *data;
    int64_t at, end; /* of data: the next byte, and one past the last */
} Span;

/* Whether a part of n bytes lies within them; no sum of foreign numbers, which might overflow. */
static inline bool is_within(int64_t at, int64_t length, int64_t n)
{
    return at >= 0 && length >= 0 && at <= n && length <= n - at;
}

static inline int64_t left_in(const Span *in) { return in->end - in->at; }

/* Little-endian numbers, as this processor has them too, at any address. */
static inline int64_t i64_at(const uint8_t *data)
{
    int64_t value;
    memcpy(&value, data, sizeof value);
    return value;
}

static inline uint16_t u16_at(const uint8_t *data)
{
    uint16_t value;
    memcpy(&value, data, sizeof value);
    return value;
}

/* Protocol Buffers: seven bits a byte, the lowest first; the eighth says that more follow. */
static inline bool take_varint(Span *in, int64_t *value)
{
    uint64_t found = 0;
    for (int shift = 0; shift < 63 && in->at < in->end; shift += 7) {
        uint8_t byte = in->data[in->at++];
        found |= (uint64_t)(byte & 127) << shift;
        if (byte < 128) {
            *value = (int64_t)found;
            return true;
        }
    }
    return false;
}

/* A length, and the part of so many bytes that follows it. */
static inline bool take_part(Span *in, Span *part)
{
    int64_t length;
    if (!take_varint(in, &length) || length > left_in(in))
        return false;
    *part = (Span){in->data, in->at, in->at + length};
    in->at += length;
    return true;
}

static inline bool skip_bytes(Span *in, int64_t length)
{
    if (length > left_in(in))
        return false;
    in->at += length;
    return true;
}

/* A field that is not known, by its tag; groups and field 0 are none. */
static inline bool skip_field(Span *in, uint8_t tag)
{
    int64_t value;
    Span part;
    if (tag >> 3 == 0)
        return false;
    switch (tag & 7) {
    case 0:
        return take_varint(in, &value);
    case 1:
        return skip_bytes(in, 8);
    case 2:
        return take_part(in, &part);
    case 5:
        return skip_bytes(in, 4);
    default:
        return false;
    }
}

/* Nanoseconds of a google.protobuf.Timestamp that fills the span. */
static inline bool take_stamp(Span *in, int64_t *stamp_ns)
{
    int64_t seconds = 0, nanos = 0;
    while (left_in(in) > 0) {
        uint8_t tag = in->data[in->at++];
        if ((tag != 1 << 3 && tag != 2 << 3) || !take_varint(in, tag == 1 << 3 ? &seconds : &nanos))
            return false;
    }
    if (seconds > 9000000000 || nanos > 999999999)
        return false;
    *stamp_ns = seconds * 1000000000 + nanos;
    return true;
}

#endif
