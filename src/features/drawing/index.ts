/* A contour from a drawing, picked on its picture. */

export const fetchDrawingDialog = () => import("./DrawingDialog.tsx");
