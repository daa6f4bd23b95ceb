// The picture as a file: mesh, overlay, title and legend.

function pictureOf(view) {
  const {stage: {base, over}, camera, look} = view;
  const ratio = base.width / camera.width;
  const items = view.mesh ? legendItems(view) : [];
  const head = 30, foot = items.length > 0 ? legendHeight(items, camera.width) + 14 : 0;
  const sheet = document.createElement("canvas");
  sheet.width = base.width;
  sheet.height = Math.round((head + camera.height + foot) * ratio);
  const context = sheet.getContext("2d");
  context.fillStyle = rgbText(look.surface);
  context.fillRect(0, 0, sheet.width, sheet.height);
  context.drawImage(base, 0, head * ratio);
  context.drawImage(over, 0, head * ratio);
  context.scale(ratio, ratio);
  context.font = `600 14px ${look.font}`;
  context.textBaseline = "middle";
  context.fillStyle = rgbText(look.text);
  context.fillText(pictureTitle(view), 8, head / 2, camera.width - 16);
  context.translate(0, head + camera.height + 10);
  paintLegend(context, items, camera.width, look);
  return sheet;
}

function pictureTitle(view) {
  return `${view.name}, cycle ${view.cycle}`;
}

function savePicture(view) {
  drawMeshView(view);
  pictureOf(view).toBlob((blob) =>
    downloadText(fileStem(`${view.name}-cycle-${view.cycle}`) + ".png", blob, "image/png"));
}
