import { localized } from "../state/localized";
import { get, getFile, post } from "./http";
import type { BlockDesignState, BlockRequest, BoardDesignView } from "./wire";

const DESIGNS = "/api/designs";

export type SensorNumbers = Omit<BlockRequest, "page">;

/** The designed block, or how far it is; what a page asks for next takes the place of this. */
export const designBlock = async (page: string, numbers: SensorNumbers) =>
  localized(await post<BlockDesignState>(`${DESIGNS}/block`, { page, ...numbers }));

export type BlockFile = "block.pdf" | "block.dxf" | "block.stl" | "block.step";

export const getBlockFile = (id: string, file: BlockFile, name: string, lang: string) =>
  getFile(`${DESIGNS}/block/${id}/${file}?${new URLSearchParams({ name, lang })}`);

/** A board to print, by the fields of its address. */
export const designBoard = (board: Record<string, string>) =>
  get<BoardDesignView>(`${DESIGNS}/board?${new URLSearchParams(board)}`);

export const getBoardPage = (board: Record<string, string>, lang: string) =>
  getFile(`${DESIGNS}/board/board.pdf?${new URLSearchParams({ ...board, lang })}`);
