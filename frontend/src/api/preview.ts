import { localized } from "../state/localized";
import { Interest } from "./interest";
import type { PreviewHeader } from "./wire";

export interface Preview {
  header: PreviewHeader;
  image: ImageBitmap;
  /** performance.now() of its arrival. */
  at: number;
}

type Draw = (preview: Preview) => void;

/** In live pictures. */
export const previewInterest = new Interest<Draw>();

/** Asks for live pictures while mounted. */
export function watchPreview(draw: Draw): () => void {
  return previewInterest.watch(draw);
}

/** 4 bytes big-endian length of the header, the header, a JPEG. */
export function parsePreview(message: ArrayBuffer): { header: PreviewHeader; jpeg: Blob } {
  const length = new DataView(message).getUint32(0);
  const text = new TextDecoder().decode(new Uint8Array(message, 4, length));
  return {
    header: localized(JSON.parse(text) as PreviewHeader),
    jpeg: new Blob([new Uint8Array(message, 4 + length)], { type: "image/jpeg" }),
  };
}

/** Draws in the next animation frame; resolves with the sequence number to acknowledge. */
export async function showPreview(message: ArrayBuffer): Promise<number> {
  const { header, jpeg } = parsePreview(message);
  const at = performance.now();
  let image: ImageBitmap;
  try {
    image = await createImageBitmap(jpeg);
  } catch {
    return header.seq;
  }
  await new Promise((resolve) => requestAnimationFrame(resolve));
  for (const draw of previewInterest.watchers) draw({ header, image, at });
  image.close();
  return header.seq;
}
