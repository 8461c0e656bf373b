import { lazyPart } from "../../app/base/parts.ts";
import { newProgramSlot } from "../../app/fields/slots.ts";
import { fetchShownTexts } from "../../app/base/settings/use-texts.ts";

/** Loaded with its texts on first use. */
const NewProgram = lazyPart(async () => {
  const [dialog] = await Promise.all([newProgramSlot.fetch(), fetchShownTexts()]);
  return { default: dialog };
});

/** The dialog that creates a program; the open work stays until the program is ready. */
export function CreateProgram({ done }: { readonly done: () => void }) {
  return <NewProgram done={done} />;
}
