import { CHUCK_SIZES } from "../../../kernel/area/clamping.ts";
import { clampingField, isNeeded } from "../../../program/clamping/draft.ts";
import {
  CENTRE_ANGLE,
  CLAMPING_KINDS,
  CLAMPING_WORDS,
  wordsOfKind,
  type ClampingDraft,
  type ClampingWord,
} from "../../../program/clamping/words.ts";
import { Icon } from "../../base/Icon.tsx";
import { useTextsOrNull } from "../../base/settings/use-texts.ts";
import { NumberField } from "./NumberField.tsx";
import "./clamping.css";

interface Props {
  /** As typed; null where nothing is stated. */
  readonly draft: ClampingDraft | null;
  /** `place` names what changes, so that typing in it is one step of undo. */
  readonly set: (draft: ClampingDraft | null, place: string | null) => void;
  /** Initial values of a clamping. */
  readonly propose: () => ClampingDraft;
  readonly inch?: boolean;
  /** Prefix of the ids of its fields where it is not the clamping of the open work: findings of that are not its own. */
  readonly of?: string;
}

/** Words of the tailstock, and of the limits. */
const CENTRE: readonly ClampingWord[] = ["QUILL", "TIP", "ANGLE"];
/** The fields in their order, the switch of the tailstock before its own. */
const WORDS = CLAMPING_WORDS.flatMap((word) => (word === CENTRE[0] ? (["tailstock", word] as const) : [word]));
const DIAMETERS: ReadonlySet<ClampingWord> = new Set(["D", "SIZE", "QUILL", "LIMITX"]);

/** Clamping of the workpiece: not stated, or kind and values. */
export function ClampingFields({ draft, set, propose, inch = false, of = "" }: Props) {
  const t = useTextsOrNull("clamping");
  if (!t) return null;
  if (!draft)
    return (
      <>
        <p className="small soft">{t.unstated}</p>
        <p>
          <button type="button" className="button" onClick={() => set(propose(), null)}>
            <Icon name="add" /> {t.state}
          </button>
        </p>
      </>
    );
  const { kind, words } = draft,
    isBetween = kind === "centres";
  const onCentre = isBetween || CENTRE.some((word) => word in words);
  const put = (word: ClampingWord, text: string) => {
    const { [word]: _, ...others } = words;
    const isEmpty = text.trim() === "" && !CENTRE.includes(word);
    set({ kind, words: isEmpty ? others : { ...words, [word]: text } }, `clamping ${word}`);
  };
  const others = Object.fromEntries(Object.entries(words).filter(([word]) => !CENTRE.some((each) => each === word)));
  const unitOf = (word: ClampingWord) =>
    word === "ANGLE" ? "°" : t.units[inch ? "inch" : "mm"][DIAMETERS.has(word) ? "diameter" : "length"];
  const tailstock = (
    <label key="tailstock" className="choice">
      <input
        type="checkbox"
        checked={onCentre}
        onChange={({ currentTarget: { checked } }) =>
          set({ kind, words: checked ? { ...others, QUILL: "", TIP: "" } : others }, null)
        }
      />
      <span>{t.tailstock}</span>
    </label>
  );
  const shown = wordsOfKind(kind).filter((word) => onCentre || !CENTRE.includes(word));
  return (
    <>
      <label className="setup-field">
        <span>{t.kind}</span>
        <select
          className="select"
          value={kind}
          onChange={({ currentTarget: { value } }) => {
            const next = CLAMPING_KINDS.find((each) => each === value) ?? kind;
            set({ kind: next, words }, null);
          }}
        >
          {CLAMPING_KINDS.map((each) => (
            <option key={each} value={each}>
              {t.kinds[each]}
            </option>
          ))}
        </select>
      </label>
      {WORDS.map((word) => {
        if (word === "tailstock") return isBetween ? null : tailstock;
        if (!shown.includes(word)) return null;
        const field = clampingField(word, isNeeded(kind, word) || (onCentre && (word === "QUILL" || word === "TIP")));
        const name = word === "D" ? t.grips[kind] : word === "SIZE" && kind === "collet" ? t.nose : t.words[word];
        const typed = words[word] ?? "";
        return (
          <div key={word}>
            <NumberField
              field={{ ...field, id: of + field.id }}
              name={name}
              unit={unitOf(word)}
              text={typed}
              onText={(text) => put(word, text)}
              {...(word === "ANGLE" && { proposal: String(CENTRE_ANGLE) })}
            />
            {word === "SIZE" && kind !== "collet" && !inch && (
              <div className="clamping-sizes" role="group" aria-label={t.words.SIZE}>
                {CHUCK_SIZES.map((size) => (
                  <button
                    key={size}
                    type="button"
                    className="button small"
                    aria-pressed={typed === String(size)}
                    onClick={() => put("SIZE", String(size))}
                  >
                    {size}
                  </button>
                ))}
              </div>
            )}
          </div>
        );
      })}
      <p className="small soft">{t.known}</p>
      <p>
        <button type="button" className="button" onClick={() => set(null, null)}>
          {t.remove}
        </button>
      </p>
    </>
  );
}
