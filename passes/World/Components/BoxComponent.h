// A box that nothing touches: its size, for code that reads it. Source: engine files Components/BoxComponent.h,
// Components/ShapeComponent.h.
#pragma once

#include "Components/PrimitiveComponent.h"

class DRYDOCK_API UBoxComponent : public UPrimitiveComponent
{
public:
	DRYDOCK_CLASS(UBoxComponent, UPrimitiveComponent)
	using UPrimitiveComponent::UPrimitiveComponent;

	void OnRegister() override { USceneComponent::OnRegister(); } // it is not a mesh: nobody misses its picture

	/** Half its sides, cm. */
	void SetBoxExtent(const FVector& InBoxExtent, bool = true) { BoxExtent = InBoxExtent; }
	void InitBoxExtent(const FVector& InBoxExtent) { BoxExtent = InBoxExtent; }
	FVector GetUnscaledBoxExtent() const { return BoxExtent; }
	FVector GetScaledBoxExtent() const { return BoxExtent * GetComponentScale(); }

private:
	FVector BoxExtent = FVector(32.0, 32.0, 32.0);
};
