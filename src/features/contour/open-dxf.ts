import type { ParsedDxf } from "../../program/dxf/read-dxf.ts";
import { retryImport } from "../../app/base/parts.ts";

/** Largest file that is read, bytes. */
const LARGEST = 20_000_000;

/** A drawing that was opened, or why it was not. */
export type OpenedDxf =
  | { readonly kind: "drawing"; readonly name: string; readonly dxf: ParsedDxf }
  | {
      readonly kind: "unreadable" | "tooLarge";
      readonly name: string;
    };

/** Opens a DXF file; loads the parser on first use. Never throws. */
export async function openDxf(file: File): Promise<OpenedDxf> {
  if (file.size > LARGEST) return { kind: "tooLarge", name: file.name };
  const parser = await retryImport(() => import("dxf-parser"));
  try {
    const text = await file.text();
    const dxf = new parser.default().parseSync(text) as ParsedDxf | null;
    return dxf?.entities ? { kind: "drawing", name: file.name, dxf } : { kind: "unreadable", name: file.name };
  } catch {
    return { kind: "unreadable", name: file.name };
  }
}
