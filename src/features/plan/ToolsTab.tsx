import type { FinishedPart } from "../../planning/part/finished-part.ts";
import type { ShopRules } from "../../planning/types.ts";
import { USUAL_RULES } from "../../planning/shop-rules.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { toolsOnDevice, useTools } from "../../app/document/tool-store.ts";
import { showTools } from "../../app/place/place.ts";
import { editPart, type StoredPart } from "../../app/records/part-store.ts";
import { cycleName, type PlanWords } from "../../app/fields/plan/plan-words.ts";
import { ValueField } from "./ValueField.tsx";

interface Props {
  readonly words: PlanWords;
  readonly stored: StoredPart;
  readonly onPart: (part: FinishedPart, place: string | null) => void;
}

const COSTS = [
  "toolChange",
  "usualTool",
  "finishBeforeRough",
  "insideBeforeOutside",
  "thinBeforeLong",
  "tolerancedLast",
] as const;
const AXES = ["diameter", "z"] as const;

/** Which tools and cycles a plan may use, and the rules of the shop. */
export function ToolsTab({ words, stored, onPart }: Props) {
  const { t, work } = words;
  const { tools } = toolsOnDevice(useTools((s) => s.list)).table;
  const { withoutTools, withoutCycles, part } = stored;
  const excludeTools = (numbers: readonly number[]) => editPart((now) => ({ ...now, withoutTools: numbers }));
  const setRule = (name: keyof ShopRules, value: ShopRules[keyof ShopRules] | undefined, place: string) => {
    const { [name]: _, ...others } = part.rules;
    onPart({ ...part, rules: value === undefined ? others : { ...others, [name]: value } }, place);
  };
  const allowance = part.rules.allowance ?? USUAL_RULES.allowance;
  const allowed = tools.filter(({ T }) => !withoutTools.includes(T)).length;
  return (
    <div className="plan-fields">
      <fieldset className="setup-group">
        <legend>{t.tools.title}</legend>
        {tools.length === 0 && <p className="small soft">{t.tools.noTool}</p>}
        <div className="plan-tool-bar">
          <span className="small soft">{t.tools.count(allowed, tools.length)}</span>
          <button
            type="button"
            className="button small"
            disabled={withoutTools.length === 0}
            onClick={() => excludeTools([])}
          >
            {t.tools.all}
          </button>
          <button
            type="button"
            className="button small"
            disabled={allowed === 0}
            onClick={() => excludeTools(tools.map(({ T }) => T))}
          >
            {t.tools.none}
          </button>
          <button type="button" className="button small" onClick={() => showTools()}>
            {t.tools.table}
          </button>
        </div>
        <ul className="plan-tools">
          {tools.map(({ T, NAME, TYPE }) => (
            <li key={T}>
              <label className="choice">
                <input
                  type="checkbox"
                  checked={!withoutTools.includes(T)}
                  onChange={({ currentTarget: { checked } }) =>
                    excludeTools(checked ? withoutTools.filter((n) => n !== T) : [...withoutTools, T])
                  }
                />
                <span>
                  <b className="number">{T}</b> {NAME} <span className="soft small">{work.setup.tool.types[TYPE]}</span>
                </span>
              </label>
            </li>
          ))}
        </ul>
      </fieldset>
      {withoutCycles.length > 0 && (
        <fieldset className="setup-group">
          <legend>{t.tools.cycles}</legend>
          <ul className="plan-tools">
            {withoutCycles.map((number) => (
              <li key={number} className="plan-cycle">
                <span>{cycleName(words, number)}</span>
                <button
                  type="button"
                  className="button small"
                  aria-label={t.tools.allowLong(String(number))}
                  onClick={() =>
                    editPart((now) => ({ ...now, withoutCycles: now.withoutCycles.filter((n) => n !== number) }))
                  }
                >
                  <Icon name="add" /> {t.tools.allow}
                </button>
              </li>
            ))}
          </ul>
        </fieldset>
      )}
      <details className="plan-rules">
        <summary>{t.rules.title}</summary>
        <p className="small soft">{t.rules.about}</p>
        {COSTS.map((name) => (
          <ValueField
            key={name}
            name={t.rules[name]}
            unit={t.rules.seconds}
            range={[0, 3600]}
            value={part.rules[name]}
            usual={USUAL_RULES[name]}
            onValue={(value) => setRule(name, value, `rule ${name}`)}
          />
        ))}
        {AXES.map((axis) => (
          <ValueField
            key={axis}
            name={axis === "z" ? t.rules.allowanceZ : t.rules.allowanceX}
            unit={axis === "z" ? t.rules.millimetres : t.rules.diameter}
            range={[0, 20]}
            value={part.rules.allowance?.[axis]}
            usual={USUAL_RULES.allowance[axis]}
            onValue={(value) => {
              const next = { ...allowance, [axis]: value ?? USUAL_RULES.allowance[axis] };
              const isUsual = AXES.every((each) => next[each] === USUAL_RULES.allowance[each]);
              setRule("allowance", isUsual ? undefined : next, `rule allowance ${axis}`);
            }}
          />
        ))}
      </details>
    </div>
  );
}
