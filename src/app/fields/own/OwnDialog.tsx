import { formatNumber, formatSigned } from "../../../i18n/number.ts";
import { OWN_DECIMALS } from "../../../program/edits/own-cycle.ts";
import { valueAsTyped } from "../../../program/values/typed-value.ts";
import { DialogDone } from "../dialog/DialogDone.tsx";
import { PromptDialog } from "../dialog/PromptDialog.tsx";
import { promptOf, type Prompt, type PromptSession } from "../dialog/session.ts";
import type { FindingEntry } from "../../findings/entry.ts";
import { Icon } from "../../base/Icon.tsx";
import { CycleInWork } from "../../calculation/issue-text.ts";
import { mayTakeKeyboard, openPrompt, showOwn, usePlace } from "../../place/place.ts";
import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { OwnBlock, OwnPrompt } from "../blocks/own-block.ts";
import { libraryOf } from "../../document/own-reading.ts";
import { useOwn } from "../../document/own-store.ts";

interface Props {
  readonly block: OwnBlock;
  readonly problems: readonly FindingEntry[];
  readonly set: (q: string, text: string) => void;
}

/** The prompts of a block as the operator has described them. */
function useOwnSession({ block, problems, set }: Props): PromptSession {
  const { dialog: t, editor } = useTexts();
  const { own: words } = useTexts("tables");
  const language = useSettings((s) => s.language);
  const opened = usePlace();
  const { parameters, draft, readings } = block;

  const number = (n: number) => formatNumber(language, n, OWN_DECIMALS);
  const unitOf = ({ kind }: OwnPrompt): string => {
    if (kind === "length") return t.units.axial;
    if (kind === "angle") return t.units.degrees;
    return kind === "feed" ? t.units[block.perRevolution ? "perRevolution" : "perMinute"] : t.units.none;
  };
  const shownOf = (p: OwnPrompt): Prompt["shown"] => {
    const { empty = true, value = null, written = null } = readings[p.q] ?? {};
    if (empty) return { text: t.noValue, unit: "", soft: true };
    if (written === "auto" || written === "max") return { text: `F${written.toUpperCase()}`, unit: "", soft: false };
    if (value === null) return { text: draft[p.q] ?? "", unit: unitOf(p), soft: false };
    const isParameter = typeof written === "object" && written !== null;
    const signed = p.kind === "length" || p.kind === "angle";
    const text = isParameter ? valueAsTyped(written) : signed ? formatSigned(language, value) : number(value);
    return { text, unit: unitOf(p), soft: false };
  };
  const asked = (p: OwnPrompt): Prompt =>
    promptOf(
      { id: p.q, decimals: OWN_DECIMALS },
      { prompt: p.prompt, about: words.unprovedLong },
      {
        page: ["guide", String(block.own.number), p.q],
        name: t.value(p.q, p.prompt),
        unit: unitOf(p),
        range: p.bounded ? t.range(number(p.range[0]), number(p.range[1])) : null,
        notes: [...(p.bounded || p.choices ? [] : [words.anyNumber]), ...(p.described ? [] : [words.notDescribed])],
        choices: p.choices?.map(({ value, meaning }) => ({ value: String(value), meaning })) ?? null,
        auto: p.kind === "feed",
        shown: shownOf(p),
      },
    );
  return {
    fields: parameters.map(asked),
    draft,
    readings,
    findings: problems,
    set,
    otherFindings: () => [],
    picture: (
      <div className="own-said">
        <Icon name="warning" /> <p className="small">{editor.ownUnproved}</p>
        <button
          type="button"
          className="button"
          onClick={() => {
            const { list } = useOwn.getState();
            showOwn(list.find((entry) => libraryOf(list).rows.get(entry.id)?.number === block.own.number)?.id);
          }}
        >
          {words.change}
        </button>
      </div>
    ),
    opened: { id: opened.prompt, before: opened.before, focus: opened.focus },
    open: openPrompt,
    mayFocus: mayTakeKeyboard,
    asksParameters: false,
    keypad: "sums",
  };
}

/** Dialog of an own cycle, with a note that it is not simulated. */
export function OwnDialog(props: Props) {
  const { dialog: t } = useTexts();
  const session = useOwnSession(props);
  return (
    <CycleInWork value={null}>
      <PromptDialog session={session} name={t.form} listName={t.list} done={<DialogDone session={session} inBlock />} />
    </CycleInWork>
  );
}
