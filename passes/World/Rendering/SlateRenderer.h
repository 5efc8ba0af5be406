// The user interface's renderer: there is no user interface here. Source: engine file Rendering/SlateRenderer.h.
#pragma once

#include "CoreMinimal.h"
#include "RHI.h"

class FSlateRenderer;
