#pragma once

#include "CoreMinimal.h"
#include "Modules/ModuleInterface.h"
#include "Templates/SharedPointer.h"

class FHalfBrightExtension;

class HALFBRIGHT_API FHalfBrightModule : public IModuleInterface
{
public:
	virtual void StartupModule() override;
	virtual void ShutdownModule() override;

private:
	void OnPostEngineInit();

	TSharedPtr<FHalfBrightExtension, ESPMode::ThreadSafe> Extension;
	FDelegateHandle PostEngineInitHandle;
};
