// Materials and the renderer's module, which do nothing here.
#include "EngineModule.h"
#include "Materials/MaterialInterface.h"

UMaterialInstanceDynamic* UMaterialInstanceDynamic::Create(UMaterialInterface* Parent, UObject* Outer)
{
	UMaterialInstanceDynamic* const Instance = NewObject<UMaterialInstanceDynamic>(Outer);
	Instance->Parent = Parent;
	return Instance;
}

IRendererModule& GetRendererModule()
{
	static IRendererModule Module;
	return Module;
}
