// Materials and the renderer's module, which do nothing here.
#include "EngineModule.h"
#include "Materials/MaterialInterface.h"
#include "Modules/ModuleManager.h"

UMaterialInstanceDynamic* UMaterialInstanceDynamic::Create(UMaterialInterface* Parent, UObject* Outer)
{
	UMaterialInstanceDynamic* const Instance = NewObject<UMaterialInstanceDynamic>(Outer);
	Instance->Parent = Parent;
	Drydock::SayNeutral(TEXT("UMaterialInstanceDynamic"), TEXT("no material is drawn; its parameters are kept"));
	return Instance;
}

IMPLEMENT_MODULE(IRendererModule, Renderer)

IRendererModule& GetRendererModule()
{
	return FModuleManager::LoadModuleChecked<IRendererModule>(TEXT("Renderer"));
}
