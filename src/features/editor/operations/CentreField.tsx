import { useId } from "react";
import type { InsertTexts } from "../../../i18n/en/insert.ts";
import { formatNumber } from "../../../i18n/number.ts";
import { boxOf } from "../../../kernel/area/box.ts";
import { centreHoles } from "../../../kernel/cutter/centre-drill.ts";
import type { Ring } from "../../../kernel/geometry/point.ts";
import { CENTRE_FORMS, type CentreHole } from "../../../kernel/plan/tool.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import { Message } from "../../../app/base/Message.tsx";
import { useSettings } from "../../../app/base/settings/settings.ts";

const nameOf = ({ form, d1, d2, d3 }: CentreHole): string => `ISO 6411-${form} ${d1}/${form === "B" ? d3 : d2}`;

/** The centre hole of form A that is the guide value for the diameter of a stock. */
export function proposedCentre(stock: readonly Ring[]): string {
  const points = stock.flat();
  const across = points.length === 0 ? 0 : toDiameter(radius(boxOf(points).high));
  const hole = centreHoles("A").find(({ over, upTo }) => across > over && across <= upTo);
  return hole ? nameOf(hole) : "";
}

interface Props {
  readonly words: InsertTexts["hand"]["hole"];
  readonly text: string;
  /** The hole that the text names; null for none. */
  readonly hole: CentreHole | null;
  readonly onText: (text: string) => void;
}

/** The designation of a centre hole, typed or chosen. */
export function CentreField({ words, text, hole, onText }: Props) {
  const id = useId();
  const language = useSettings((s) => s.language);
  const write = (n: number) => formatNumber(language, n);
  return (
    <label htmlFor={id} className="wide">
      <span>{words.name}</span>
      <input
        id={id}
        className="input"
        list={`${id}-sizes`}
        autoComplete="off"
        spellCheck={false}
        value={text}
        aria-invalid={!hole}
        aria-describedby={`${id}-said`}
        data-open={!hole || undefined}
        onChange={(event) => onText(event.target.value)}
      />
      <datalist id={`${id}-sizes`}>
        {CENTRE_FORMS.flatMap(centreHoles).map((each) => (
          <option key={nameOf(each)} value={nameOf(each)} />
        ))}
      </datalist>
      <span id={`${id}-said`} className="small soft">
        {!hole && (
          <Message as="span" tone="warning">
            {words.unknown}
          </Message>
        )}
        {hole && `${words.size(write(hole.d3), write(hole.t))} ${hole.form === "R" ? words.formR : words.pilot}`}
      </span>
    </label>
  );
}
