// The renderer as a module. Source: engine files EngineModule.h, RendererInterface.h (IRendererModule).
#pragma once

#include "CoreMinimal.h"
#include "Modules/ModuleInterface.h"
#include "RendererInterface.h"

class DRYDOCK_API IRendererModule : public IModuleInterface
{
};

DRYDOCK_API IRendererModule& GetRendererModule();
