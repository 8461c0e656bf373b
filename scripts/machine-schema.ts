import { z } from "zod";
import { machineSchema } from "../src/program/machine/machine-file.ts";

/**
 * The JSON schema of machine files, from the schema that reads them. Output settings of programs have separate rules.
 */
export const machineJsonSchema = (): string =>
  `${JSON.stringify({ title: "Turnwise machine", ...z.toJSONSchema(machineSchema, { io: "input", unrepresentable: "any" }) }, null, 2)}\n`;
