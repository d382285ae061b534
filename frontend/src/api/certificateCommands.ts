import { localized } from "../state/localized";
import { DATASHEETS } from "./datasheetCommands";
import { post, postForFile } from "./http";
import type { BlockCertificateView, MeasuredBlock } from "./wire";

const CERTIFICATE = `${DATASHEETS}/block-certificate`;

/** The faces of a measured block with their uncertainties; nothing is kept. */
export const certifyBlock = async (measured: MeasuredBlock) =>
  localized(await post<BlockCertificateView>(CERTIFICATE, measured));

export const getCertificatePage = (measured: MeasuredBlock, lang: string) =>
  postForFile(`${CERTIFICATE}/page?lang=${lang}`, measured);
