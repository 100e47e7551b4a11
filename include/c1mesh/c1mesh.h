// SPDX-License-Identifier: GPL-3.0-or-later
// Everything: read, check, parametrize, trade off, verify, evaluate, write, generate.
#pragma once

#include "c1mesh/barycentric.h"
#include "c1mesh/certificate.h"
#include "c1mesh/cost.h"
#include "c1mesh/error.h"
#include "c1mesh/evaluate.h"
#include "c1mesh/font.h"
#include "c1mesh/generate.h"
#include "c1mesh/map.h"
#include "c1mesh/options.h"
#include "c1mesh/parametrize.h"
#include "c1mesh/progress.h"
#include "c1mesh/project.h"
#include "c1mesh/result.h"
#include "c1mesh/shape.h"
#include "c1mesh/trace.h"
#include "c1mesh/trade_off.h"
#include "c1mesh/types.h"
#include "c1mesh/verify.h"
#include "c1mesh/version.h"
#include "c1mesh/write.h"
