import { useMeasureTexts } from "./measure-words.ts";
import "./measure.css";

/** Over a picture that cannot show what was measured: how much there is, and where it is seen. */
export const MeasuredElsewhere = ({ count }: { readonly count: number }) => {
  const t = useMeasureTexts();
  return <p role="status" className="measured-elsewhere small">{t.inSection(String(count))}</p>;
};
