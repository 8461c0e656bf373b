import { z } from "zod";
import { machineSchema } from "../src/program/machine/machine-file.ts";

/**
 * The JSON schema of machine files, from the one that reads them. How programs are written is held to its own rules.
 */
export const machineJsonSchema = (): string =>
  `${JSON.stringify({ title: "Turnwise machine", ...z.toJSONSchema(machineSchema, { io: "input", unrepresentable: "any" }) }, null, 2)}\n`;
