// The renderer as a module. Source: engine file EngineModule.h.
#pragma once

#include "CoreMinimal.h"
#include "RendererInterface.h"

DRYDOCK_API IRendererModule& GetRendererModule();
