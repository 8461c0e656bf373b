import { openText } from "../../app/fields/open/open-program.ts";

/** The text of a built-in example program. */
export async function exampleText(id: string): Promise<string | undefined> {
  const { examples } = await import("../../examples/index.ts");
  return examples.find((example) => example.id === id)?.text;
}

/** Opens one of the built-in example programs. Without a network nothing opens later: the click can be repeated. */
export async function openExample(id: string): Promise<void> {
  const text = await exampleText(id);
  if (text !== undefined) openText(text);
}
