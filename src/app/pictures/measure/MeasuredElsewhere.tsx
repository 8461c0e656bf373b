import "./measure.css";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Over a picture that cannot show what was measured: how much there is, and where it is seen. */
export const MeasuredElsewhere = ({ count }: { readonly count: number }) => {
  const t = useTexts("measure");
  return (
    <p role="status" className="measured-elsewhere small">
      {t.inSection(String(count))}
    </p>
  );
};
