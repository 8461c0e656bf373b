import { Suspense } from "react";
import { lazyPart } from "../../app/base/parts.ts";
import { newProgramSlot } from "../../app/fields/slots.ts";
import { fetchShownTexts } from "../../app/base/settings/use-texts.ts";

/** Fetched with its texts when it is first opened. */
const NewProgram = lazyPart(async () => {
  const [dialog] = await Promise.all([newProgramSlot.fetch(), fetchShownTexts()]);
  return { default: dialog };
});

/** The dialog that begins a program, over whatever is open: that stays as it is until the program is there. */
export function CreateProgram({ done }: { readonly done: () => void }) {
  return (
    <Suspense>
      <NewProgram done={done} />
    </Suspense>
  );
}
