/* Works that come from elsewhere, or go there. */

export { HandedLine, IncomingWork } from "./HandedParts.tsx";
export const fetchHandOnDialog = () => import("./HandOnDialog.tsx");
