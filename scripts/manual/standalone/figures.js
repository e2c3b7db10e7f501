// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers the figures: every link to one becomes "Figure n", n counting the figures of the page.
const numbers = new Map();
for (const anchor of document.querySelectorAll('a.anchor[id^="fig__"]'))
  numbers.set('#' + anchor.id, numbers.size + 1);
for (const link of document.querySelectorAll('a[href*="#fig__"]')) {
  const number = numbers.get(link.hash);
  if (number && link.textContent === 'Figure')
    link.textContent = 'Figure ' + number;
}
