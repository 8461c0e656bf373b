import type { Control } from "../../program/plane-types.ts";
import type { ShopTools } from "../../program/read-tools.ts";
import type { WorkFile } from "../work.ts";

/** A program to calculate. */
export interface Request {
  readonly version: number;
  readonly text: string;
  /** Name of its file. */
  readonly name?: string;
  /** The files beside it: what it can call. */
  readonly files?: readonly Pick<WorkFile, "name" | "text">[];
  /** Blocks behind a skip mark are left out. */
  readonly skipMarked?: boolean;
  /** The tools that the program can call. */
  readonly table: ShopTools;
  /** Rapid rate for times, mm/min. */
  readonly rapid: number;
  /** How APPR and DEP move in the tool axis. */
  readonly control: Control;
}
