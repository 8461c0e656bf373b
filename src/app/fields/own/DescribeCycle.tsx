import type { StatementOf } from "../../../nc/statement.ts";
import { isKnownCycle } from "../../../program/edits/own-cycle.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { describeBlock, isFull } from "../blocks/own-edits.ts";
import { showOwn } from "../../place/place.ts";
import { libraryOf } from "../../document/own-reading.ts";
import { useOwn } from "../../document/own-store.ts";

/** Button from a block with an unknown cycle to its description, proposed from the text of the block. */
export function DescribeCycle({ statement }: { readonly statement: StatementOf<"cycle"> }) {
  const t = useTexts("tables").own;
  const list = useOwn((s) => s.list);
  if (isKnownCycle(statement.cycle)) return null;
  const begun = [...libraryOf(list).rows.values()].some(({ number }) => number === statement.cycle);
  return (
    <div className="describe-cycle">
      <p className="small soft">{t.describeAbout}</p>
      <button
        type="button"
        className="button"
        disabled={!begun && isFull(list)}
        onClick={() => showOwn(describeBlock(statement), true)}
      >
        <Icon name="add" /> {begun ? t.change : t.describe}
      </button>
    </div>
  );
}
