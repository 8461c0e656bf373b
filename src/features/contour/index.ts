/* A contour as a table and as a drawing. */

export const fetchContourStage = () => import("./ContourStage.tsx");
export const fetchContourTable = () => import("./ContourTable.tsx");
