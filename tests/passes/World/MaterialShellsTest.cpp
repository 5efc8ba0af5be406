// Materials keep their parent, and the renderer is found as a module: neither draws.
#include <gtest/gtest.h>

#include "EngineModule.h"
#include "Materials/MaterialInterface.h"
#include "Modules/ModuleManager.h"

#include <memory>

TEST(RendererModule, IsLoadedByName)
{
	EXPECT_EQ(&GetRendererModule(), &FModuleManager::LoadModuleChecked<IRendererModule>(TEXT("Renderer")));
}

TEST(MaterialInstance, KeepsItsParent)
{
	UMaterialInterface Parent;
	const std::unique_ptr<UMaterialInstanceDynamic> Instance(UMaterialInstanceDynamic::Create(&Parent, nullptr));
	ASSERT_NE(nullptr, Instance);
	EXPECT_EQ(&Parent, Instance->GetParent());
}
