import { blockNumbers } from "../../../nc/program.ts";
import { openChosen } from "../../../app/fields/blocks/choose-block.ts";
import { openBlock, readWhole, useSession } from "../../../app/fields/blocks/session.ts";
import { showFile } from "../../../app/document/shown-file.ts";

/** Opens the block with a number in the text of the open program; the tool stays in place. */
export function openBlockByNumber(block: number, q: string | null): void {
  showFile(null);
  readWhole();
  const index = blockNumbers(useSession.getState().reading.program).indexOf(block);
  if (index >= 0) openChosen(() => openBlock(index, q));
}

/**
 * Reports the number of each block that is pointed at in the text or in the list of parts. Loading a text reports
 * nothing.
 */
export function subscribePointedBlock(tell: (block: number) => void): () => void {
  return useSession.subscribe((now, before) => {
    const comes = before.index < 0;
    if (now.pointed === before.pointed && (comes || now.opened === before.opened)) return;
    const number = blockNumbers(now.reading.program)[now.index];
    if (typeof number === "number") tell(number);
  });
}
