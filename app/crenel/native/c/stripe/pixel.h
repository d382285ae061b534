/* What differs between pictures of 8 and of 16 bits.
 *
 * Files of the stripe that look at pixels are included twice, with BITS defined as 8 and as 16.
 * PIXEL is the type of a pixel, OF(name) the name with the bits behind it. */
#undef PIXEL
#undef OF
#if BITS == 8
#define PIXEL uint8_t
#define OF(name) name##_8
#else
#define PIXEL uint16_t
#define OF(name) name##_16
#endif
