import { z } from "zod";
import { partSchema } from "../src/planning/part/part-file.ts";
import { machineSchema } from "../src/program/machine/machine-file.ts";

const jsonSchema = (title: string, schema: z.core.$ZodType): string =>
  `${JSON.stringify({ title, ...z.toJSONSchema(schema, { io: "input", unrepresentable: "any" }) }, null, 2)}\n`;

/**
 * The JSON schema of machine files, from the schema that reads them. Output settings of programs have separate rules.
 */
export const machineJsonSchema = (): string => jsonSchema("Turnwise machine", machineSchema);

/** The JSON schema of part files, from the schema that reads them. */
export const partJsonSchema = (): string => jsonSchema("Turnwise part", partSchema);
