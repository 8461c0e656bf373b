/* Working plans: from a finished part to its program. */

export const fetchPartFiles = () => import("./part-files.ts");
export const fetchPlanPage = () => import("./PlanPage.tsx");
